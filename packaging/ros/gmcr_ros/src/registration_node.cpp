/// Registers each cloud on `source` to the last one on `target`, which may be a map, and publishes
/// the pose on `registration`; the service `relocalise` answers for one scan. No initial guess.

#include <gmcr/frontend.hpp>
#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>
#include <string>

#include "gmcr_ros/convert.hpp"
#include "gmcr_ros/msg/registration.hpp"
#include "gmcr_ros/srv/relocalise.hpp"

namespace gmcr_ros {

class RegistrationNode : public rclcpp::Node {
 public:
  RegistrationNode() : rclcpp::Node("gmcr") {
    frontend_.voxel_size = declare_parameter("voxel_size", frontend_.voxel_size);
    options_.noise_bound = declare_parameter("noise_bound", options_.noise_bound);
    options_.time_limit = declare_parameter("time_limit", 5.0);
    options_.num_threads = static_cast<int>(declare_parameter<std::int64_t>("num_threads", 0));

    publisher_ = create_publisher<msg::Registration>("registration", 10);
    target_subscription_ = create_subscription<Cloud>(
        "target", rclcpp::QoS(1).transient_local(),
        [this](const Cloud::ConstSharedPtr& cloud) { take_target(*cloud); });
    source_subscription_ = create_subscription<Cloud>("source", rclcpp::SensorDataQoS(),
                                                      [this](const Cloud::ConstSharedPtr& cloud) {
                                                        if (const auto message = located(*cloud))
                                                          publisher_->publish(*message);
                                                      });
    service_ = create_service<srv::Relocalise>(
        "relocalise", [this](const std::shared_ptr<srv::Relocalise::Request>& request,
                             const std::shared_ptr<srv::Relocalise::Response>& response) {
          const auto message = located(request->scan);
          if (message) response->registration = *message;
          if (!message) response->registration.status = "no target, or a cloud that cannot be read";
        });
  }

 private:
  using Cloud = sensor_msgs::msg::PointCloud2;

  void take_target(const Cloud& cloud) {
    try {
      target_ = points_of(cloud);
      target_frame_ = cloud.header.frame_id;
    } catch (const std::exception& error) {
      RCLCPP_ERROR(get_logger(), "target: %s", error.what());
    }
  }

  /// The scan in the frame of the target; nullopt where there is none, or the scan cannot be read.
  std::optional<msg::Registration> located(const Cloud& scan) const {
    if (!target_) return std::nullopt;
    try {
      msg::Registration message;
      fill(gmcr::register_clouds(points_of(scan), *target_, frontend_, options_), message);
      message.header.stamp = scan.header.stamp;
      message.header.frame_id = target_frame_;
      message.source_frame_id = scan.header.frame_id;
      return message;
    } catch (const std::exception& error) {
      RCLCPP_ERROR(get_logger(), "source: %s", error.what());
      return std::nullopt;
    }
  }

  gmcr::FrontendOptions frontend_;
  gmcr::Options options_;
  std::optional<gmcr::Points> target_;
  std::string target_frame_;
  rclcpp::Publisher<msg::Registration>::SharedPtr publisher_;
  rclcpp::Subscription<Cloud>::SharedPtr target_subscription_, source_subscription_;
  rclcpp::Service<srv::Relocalise>::SharedPtr service_;
};

}  // namespace gmcr_ros

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<gmcr_ros::RegistrationNode>());
  rclcpp::shutdown();
  return 0;
}
