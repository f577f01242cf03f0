#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

// The calls of rclcpp that the node makes; they do nothing.
#define RCLCPP_ERROR(logger, ...) static_cast<void>(logger)

namespace rclcpp {

struct QoS {
  explicit QoS(int) {}
  QoS& transient_local() { return *this; }
};
struct SensorDataQoS : QoS {
  SensorDataQoS() : QoS(5) {}
};
struct Logger {};

template <class Message>
struct Publisher {
  using SharedPtr = std::shared_ptr<Publisher>;
  void publish(const Message&) {}
};
template <class Message>
struct Subscription {
  using SharedPtr = std::shared_ptr<Subscription>;
};
template <class Type>
struct Service {
  using SharedPtr = std::shared_ptr<Service>;
};

class Node {
 public:
  explicit Node(const std::string&) {}
  Logger get_logger() const { return {}; }
  template <class Value>
  Value declare_parameter(const std::string&, const Value& value) {
    return value;
  }
  template <class Message>
  typename Publisher<Message>::SharedPtr create_publisher(const std::string&, int) {
    return {};
  }
  template <class Message>
  typename Subscription<Message>::SharedPtr create_subscription(
      const std::string&, const QoS&,
      const std::function<void(const std::shared_ptr<const Message>&)>&) {
    return {};
  }
  template <class Type>
  typename Service<Type>::SharedPtr create_service(
      const std::string&,
      const std::function<void(const std::shared_ptr<typename Type::Request>&,
                               const std::shared_ptr<typename Type::Response>&)>&) {
    return {};
  }
};

inline void init(int, char**) {}
inline void spin(const std::shared_ptr<Node>&) {}
inline void shutdown() {}

}  // namespace rclcpp
