#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace zonegrid {

/// The library through which a backend finds its drivers.
struct DriverLoader {
    std::string backend;  ///< "opencl" or "vulkan"
    std::string library;  ///< as it is looked for
    std::string variable; ///< of the environment, if that names the library; else empty
    std::string file;     ///< where it was found; empty if it was not
    std::string problem;  ///< the system's reason; empty if it was found
};

/// A file that names a driver to the loader: an OpenCL .icd or a Vulkan manifest.
struct DriverFile {
    std::string backend;
    std::filesystem::path file;
    std::string library;  ///< that it names; empty if it could not be read
    std::string problem;  ///< empty: the library can be loaded
    bool foreign = false; ///< the library is for another processor, as on systems with several
};

/// Where a backend's loader looks, and what is there.
struct InstalledDrivers {
    DriverLoader loader;
    std::vector<std::filesystem::path> places; ///< folders and files, whether they exist or not
    std::vector<DriverFile> files;
};

/// OpenCL: /etc/OpenCL/vendors, or what OCL_ICD_VENDORS names. Vulkan: the folders vulkan/icd.d, or
/// what VK_DRIVER_FILES, else VK_ICD_FILENAMES names. Drivers are loaded to see whether they can
/// be.
[[nodiscard]] InstalledDrivers find_opencl_drivers();
[[nodiscard]] InstalledDrivers find_vulkan_drivers();

} // namespace zonegrid
