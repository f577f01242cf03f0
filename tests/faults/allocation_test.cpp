// Every allocation of a call fails once, one after the other: each time the caller gets
// std::bad_alloc or a whole answer, and all memory comes back.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <new>

#include "gmcr/clique.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/io.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/report.hpp"
#include "gmcr/synthetic.hpp"
#include "io/temporary_folder.hpp"

// glibc's own, which those below stand before: operator new and Eigen call either kind
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_memalign(std::size_t alignment, std::size_t size);
extern "C" void* __libc_realloc(void* block, std::size_t size);
extern "C" void* __libc_calloc(std::size_t count, std::size_t size);
extern "C" void __libc_free(void* block);

namespace {

constexpr long kNever = std::numeric_limits<long>::max();

/// Of this thread alone; others allocate as they like.
struct Watch {
  bool is_on = false;
  long fails_at = kNever;
  long num_allocations = 0;
  long num_blocks = 0;  ///< allocated less freed

  bool refuses() { return is_on && num_allocations++ == fails_at; }
  void* allocated(void* block) {
    if (is_on && block) ++num_blocks;
    return block;
  }
};

thread_local Watch watch;

}  // namespace

#pragma GCC visibility push(default)  // so that the libraries of the system find them

extern "C" void* malloc(std::size_t size) {
  if (watch.refuses()) {
    errno = ENOMEM;
    return nullptr;
  }
  return watch.allocated(__libc_malloc(size));
}

extern "C" void* calloc(std::size_t count, std::size_t size) {
  if (watch.refuses()) {
    errno = ENOMEM;
    return nullptr;
  }
  return watch.allocated(__libc_calloc(count, size));
}

extern "C" void free(void* block) {
  if (watch.is_on && block) --watch.num_blocks;
  __libc_free(block);
}

extern "C" void* realloc(void* block, std::size_t size) {
  if (block && size == 0) {
    free(block);
    return nullptr;
  }
  if (watch.refuses()) {
    errno = ENOMEM;
    return nullptr;
  }
  void* const moved = __libc_realloc(block, size);
  return block ? moved : watch.allocated(moved);
}

extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) {
  if (watch.refuses()) {
    errno = ENOMEM;
    return nullptr;
  }
  return watch.allocated(__libc_memalign(alignment, size));
}

extern "C" int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = aligned_alloc(alignment, size);
  return *block ? 0 : ENOMEM;
}

#pragma GCC visibility pop

namespace gmcr {
namespace {

/// What a call left behind and how it ended.
struct Outcome {
  long num_allocations = 0;
  long num_blocks = 0;
  bool ran_out = false;
  std::string other;  ///< what it threw, where that is something else
};

Outcome watched(const std::function<void()>& call, long fails_at) {
  Outcome outcome;
  watch = {true, fails_at, 0, 0};
  try {
    call();
  } catch (const std::bad_alloc&) {
    outcome.ran_out = true;
  } catch (const IoError& error) {  // of fopen, which allocates too
    outcome.ran_out = error.reason() == std::strerror(ENOMEM);
  } catch (const std::exception& error) {
    watch.is_on = false;  // the words are of this function
    outcome.other = error.what();
    watch.is_on = true;
  }
  watch.is_on = false;
  outcome.num_allocations = watch.num_allocations;
  outcome.num_blocks = watch.num_blocks;
  return outcome;
}

/// @param most  failures to try, spread over all allocations.
void expect_to_survive(const std::function<void()>& call, long most = 4000) {
  call();  // what is made once and kept
  const Outcome whole = watched(call, kNever);
  ASSERT_EQ(whole.other, "");
  ASSERT_GT(whole.num_allocations, 0);
  EXPECT_EQ(whole.num_blocks, 0);
  const long step = 1 + whole.num_allocations / most;
  long num_refused = 0;
  for (long k = 0; k < whole.num_allocations; k += step) {
    const Outcome outcome = watched(call, k);
    EXPECT_EQ(outcome.other, "") << k << " of " << whole.num_allocations;
    EXPECT_EQ(outcome.num_blocks, 0) << k << " of " << whole.num_allocations;
    num_refused += outcome.ran_out;
  }
  EXPECT_GT(num_refused, 0);
}

SyntheticProblem small_problem() {
  SyntheticOptions options;
  options.num_correspondences = 24;
  options.outlier_rate = 0.5;
  return make_synthetic(options);
}

TEST(FailedAllocation, InASolveLeavesNothing) {
  const SyntheticProblem problem = small_problem();
  for (const Method method : {Method::Gmcr, Method::Paper}) {
    for (const ScaleMode scale_mode : {ScaleMode::Known, ScaleMode::Estimated}) {
      Options options;
      options.method = method;
      options.scale_mode = scale_mode;
      options.noise_bound = problem.noise_bound;
      options.num_threads = 1;
      options.num_hypotheses = method == Method::Gmcr ? 2 : 1;
      options.certify = method == Method::Gmcr && scale_mode == ScaleMode::Known;
      SCOPED_TRACE(::testing::Message() << "paper " << (method == Method::Paper) << ", scale "
                                        << (scale_mode == ScaleMode::Estimated));
      expect_to_survive([&] { register_correspondences(problem.source, problem.target, options); });
    }
  }
}

TEST(FailedAllocation, InTheChoiceOfANoiseBoundLeavesNothing) {
  const SyntheticProblem problem = small_problem();
  Options options;
  options.noise_mode = NoiseMode::Estimated;
  options.num_threads = 1;
  expect_to_survive([&] { register_correspondences(problem.source, problem.target, options); },
                    500);
}

TEST(FailedAllocation, InARegistrationOfCloudsLeavesNothing) {
  Points cloud(3, 400);
  for (Index i = 0; i < cloud.cols(); ++i) {
    const double x = 0.1 * static_cast<double>(i % 20), y = 0.1 * static_cast<double>(i / 20);
    cloud.col(i) << x, y, 0.2 * x * x - 0.1 * y * x + 0.3 * y;
  }
  Options options;
  options.num_threads = 1;
  FrontendOptions frontend;
  frontend.max_attempts = 1;
  frontend.voxel_size = 0.12;
  expect_to_survive([&] { register_clouds(cloud, cloud, frontend, options); }, 200);
}

TEST(FailedAllocation, InASearchForCliquesLeavesNothing) {
  BitsetGraph graph(70);
  for (Index u = 1; u < 70; ++u) {
    for (Index v = 0; v < u; ++v) {
      if ((u * u + 3 * v) % 7 > 1) graph.add_edge(u, v);
    }
  }
  const std::vector<double> weights(70, 1.5);
  CliqueOptions options;
  options.num_threads = 1;
  WeightedCliqueOptions weighted;
  weighted.num_threads = 1;
  expect_to_survive([&] { max_clique(graph, options); });
  expect_to_survive([&] { max_weight_clique(graph, weights, weighted); });
}

TEST(FailedAllocation, InAReaderOrAWriterLeavesNothing) {
  const test::TemporaryFolder folder;
  const Points points = small_problem().source;
  std::vector<std::filesystem::path> clouds;
  for (const char* name : {"a.ply", "a.pcd", "a.csv", "a.npy", "a.xyz"}) {
    clouds.push_back(folder / name);
    write_cloud(clouds.back(), points);
  }
  clouds.push_back(folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  clouds.push_back(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  for (const auto& path : clouds) {
    SCOPED_TRACE(path);
    expect_to_survive([&] { read_cloud(path, {.mesh_points = 5}); });
  }
  write_matches(folder / "m.csv", points, points);
  expect_to_survive([&] { read_matches(folder / "m.csv"); });
  expect_to_survive([&] { write_cloud(folder / "b.ply", points); });
  const auto graph = folder.write("g.clq", "p edge 4 2\ne 1 2\ne 2 3\n");
  expect_to_survive([&] { read_graph(graph, 1000); });
}

}  // namespace
}  // namespace gmcr
