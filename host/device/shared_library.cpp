#include "device/shared_library.h"

#include "zonegrid/errors.h"

#include <dlfcn.h>

#include <cstdlib>

namespace zonegrid::device {

namespace {

std::string library_name(const char* variable, const char* name) {
    const char* chosen = std::getenv(variable);
    return chosen == nullptr || *chosen == '\0' ? name : chosen;
}

} // namespace

SharedLibrary::SharedLibrary(const char* backend, const char* variable, const char* name,
                             const std::string& remedy)
    : backend_(backend),
      name_(library_name(variable, name)),
      // Drivers start threads and register exit handlers: their code must stay in memory.
      handle_(dlopen(name_.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE), &dlclose) {
    if (!handle_) {
        const char* reason = dlerror();
        throw DeviceError(backend_,
                          "the library " + name_ + " cannot be loaded (" +
                              (reason == nullptr ? "no reason given" : reason) + ")",
                          remedy);
    }
}

Symbol SharedLibrary::find(const char* function) const {
    void* address = dlsym(handle_.get(), function);
    if (address == nullptr) {
        throw DeviceError(backend_, name_ + " has no function " + function,
                          "install a current version of it");
    }
    return Symbol(reinterpret_cast<Symbol::Function>(address));
}

} // namespace zonegrid::device
