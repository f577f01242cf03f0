"""Recipe for Conan 2: `conan create packaging/conan`, in a clone, whose sources it builds."""

from pathlib import Path

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rmdir

ROOT = Path(__file__).resolve().parents[2]


class Gmcr(ConanFile):
    name = "gmcr"
    version = "0.2.0"
    license = "MIT"
    description = "Graph-based maximum consensus registration of 3-D point sets"
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "tool": [True, False]}
    default_options = {"shared": False, "fPIC": True, "tool": True}
    implements = ["auto_shared_fpic"]

    def export_sources(self):
        for name in ("CMakeLists.txt", "LICENSE", "README.md"):
            copy(self, name, ROOT, self.export_sources_folder)
        for folder in ("apps", "cmake", "include", "src"):
            copy(self, "*", ROOT / folder, Path(self.export_sources_folder) / folder)

    def requirements(self):
        self.requires("eigen/3.4.0", transitive_headers=True)
        self.requires("highway/1.2.0")
        self.requires("liblzf/3.6")
        self.requires("onetbb/2021.12.0")
        self.requires("fmt/10.2.1")
        self.requires("nanoflann/1.6.1")
        self.requires("nlohmann_json/3.11.3")
        if self.options.tool:
            self.requires("cli11/2.4.2")
            self.requires("spdlog/1.14.1")

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        dependencies = CMakeDeps(self)
        dependencies.set_property("highway", "cmake_file_name", "hwy")
        dependencies.set_property("highway", "cmake_target_name", "hwy::hwy")
        dependencies.generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["GMCR_BUILD_APPS"] = bool(self.options.tool)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="product")

    def package(self):
        copy(self, "LICENSE", self.source_folder, Path(self.package_folder) / "licenses")
        CMake(self).install()
        # those of Conan take the place of these
        rmdir(self, Path(self.package_folder) / "lib" / "cmake")
        rmdir(self, Path(self.package_folder) / "lib" / "pkgconfig")

    def package_info(self):
        requirements = {
            "gmcr": ["eigen::eigen", "highway::highway", "onetbb::onetbb"],
            "frontend": ["gmcr", "nanoflann::nanoflann"],
            "io": ["gmcr", "liblzf::liblzf"],
            "report": ["gmcr", "frontend", "fmt::fmt", "nlohmann_json::nlohmann_json"],
            "synthetic": ["gmcr"],
            "c": ["frontend", "report"],
        }
        if self.options.tool:
            requirements["tool"] = ["cli11::cli11", "spdlog::spdlog"]
        for name, required in requirements.items():
            component = self.cpp_info.components[name]
            component.requires = required
            component.set_property("cmake_target_name", f"gmcr::{name}")
            if name != "tool":
                component.libs = [name if name == "gmcr" else f"gmcr_{name}"]
