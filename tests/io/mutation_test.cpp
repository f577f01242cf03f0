#include <gtest/gtest.h>
#include <lzf.h>

#include "gmcr/io.hpp"
#include "io/file_bytes.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::bytes_of;
using test::Noise;
using test::TemporaryFolder;

struct Seed {
  const char* name;
  std::string bytes;
};

std::string numbers(int count) {
  std::vector<float> values;
  for (int i = 0; i < count; ++i) values.push_back(static_cast<float>(i % 7) + 0.25F);
  return bytes_of(values);
}

std::string compressed_pcd() {
  const std::string columns = numbers(4 * 12);
  std::string packed(columns.size() + 100, '\0');
  packed.resize(lzf_compress(columns.data(), static_cast<unsigned>(columns.size()), packed.data(),
                             static_cast<unsigned>(packed.size())));
  return "FIELDS x y z normal_x\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 4\nHEIGHT 3\n"
         "POINTS 12\nDATA binary_compressed\n" +
         bytes_of(static_cast<std::uint32_t>(packed.size())) +
         bytes_of(static_cast<std::uint32_t>(columns.size())) + packed;
}

std::string npy() {
  std::string bytes("\x93NUMPY\x01\0\x46\0", 10);
  bytes.append("{'descr': '<f4', 'fortran_order': False, 'shape': (4, 3), }          \n");
  return bytes.append(numbers(12));
}

std::vector<Seed> seeds() {
  const std::string vertex =
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 2\nproperty list uchar int vertex_indices\n";
  return {
      {"a.ply", "ply\nformat ascii 1.0\n" + vertex + face +
                    "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n"},
      {"b.ply", "ply\nformat binary_big_endian 1.0\n" + vertex + face + "end_header\n" +
                    numbers(12) + "\3" + std::string("\0\0\0\0\0\0\0\1\0\0\0\2", 12) + '\0'},
      {"a.pcd",
       "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 2\nPOINTS 4\n"
       "DATA ascii\n1 2 3\n4 5 6\nnan 1 2\n7 8 9\n"},
      {"b.pcd",
       "FIELDS x y z i\nSIZE 4 4 4 2\nTYPE F F F U\nCOUNT 1 1 1 2\nPOINTS 3\n"
       "DATA binary\n" +
           numbers(12)},
      {"c.pcd", compressed_pcd()},
      {"a.xyz", "//X;Y;Z\n3\n1,5;2,25;3\n4;5;6\n7;8;nan\n"},
      {"a.csv", "id,x,y,z\na,1,2,3\nb,4,5,6e-3\n"},
      {"b.csv", "\"x, m\",z,y,i\nm,m,m,-\nNA,,-,1\n\"1,5\",\"3\",'2',a\n4,6,5,\"b c\"\n"},
      {"c.ply", "ply\nformat ascii 1.0\n" + vertex +
                    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                    "0 0 1\n1 0 1\n0 1 1\n1 1 1\n8 0 1 2 3 -1 1 2 3\n"},
      {"a.pts", "2\n1 2 3 4 5 6\n4 5 6 7 8 9\n"},
      {"a.npy", npy()},
      {"a.bin", numbers(12)},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf -1 -2 -3\n"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"a.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
       "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"},
      {"b.stl", std::string(80, ' ') + bytes_of(std::uint32_t{1}) + numbers(12) + "ab"},
  };
}

/// One to four changes: a bit, a byte that means something, a piece that goes, comes twice or
/// moves.
std::string mutated(std::string bytes, Noise& noise) {
  constexpr std::string_view kTelling = " \n\r\t-+.,;#0123456789eExyz\xFF\x7F\x80";
  const std::size_t num_changes = 1 + noise.below(4);
  for (std::size_t i = 0; i < num_changes && !bytes.empty(); ++i) {
    const std::size_t at = noise.below(bytes.size());
    const std::size_t length = 1 + noise.below(std::min<std::size_t>(12, bytes.size() - at));
    switch (noise.below(6)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << noise.below(8)));
        break;
      case 1:
        bytes[at] = kTelling[noise.below(kTelling.size())];
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 4:
        bytes.insert(noise.below(bytes.size()), bytes.substr(at, length));
        break;
      default:
        bytes.insert(at, std::to_string(noise.next() >> noise.below(64)));
    }
  }
  return bytes;
}

TEST(Reader, OfDamagedFilesReturnsPointsOrThrowsIoError) {
  constexpr int kFilesOfASeed = 300;
  const TemporaryFolder folder;
  Noise noise(20260);
  int num_read = 0;
  for (const Seed& seed : seeds()) {
    ASSERT_NO_THROW(read_cloud(folder.write(seed.name, seed.bytes), {.mesh_points = 20}))
        << seed.name;
    for (int i = 0; i < kFilesOfASeed; ++i) {
      const std::string bytes = mutated(seed.bytes, noise);
      const auto path = folder.write(seed.name, bytes);
      try {
        const Cloud cloud = read_cloud(path, {.mesh_points = 20});
        ASSERT_TRUE(cloud.points.allFinite()) << seed.name << " " << i;
        ASSERT_GE(cloud.points.cols(), 1);
        ASSERT_LE(cloud.points.cols() + cloud.num_dropped, static_cast<Index>(bytes.size()) + 20);
        ++num_read;
      } catch (const IoError&) {
      } catch (const std::exception& error) {
        FAIL() << seed.name << ", file " << i << ": " << error.what();
      }
    }
  }
  EXPECT_GT(num_read, 300);  // or the changes would be too coarse to reach the readers
}

}  // namespace
}  // namespace gmcr::io
