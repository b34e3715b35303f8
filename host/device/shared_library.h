#pragma once

#include <memory>
#include <string>

namespace zonegrid::device {

/// A function found by name; becomes a pointer of the type it is assigned to.
class Symbol {
public:
    using Function = void (*)();

    explicit Symbol(Function function) : function_(function) {}

    template <class Pointer>
    operator Pointer() const {
        return reinterpret_cast<Pointer>(function_);
    }

private:
    Function function_;
};

/// A library loaded at run time. Its code stays in memory, its handle goes when destroyed.
class SharedLibrary {
public:
    /// The library named by the environment variable, else `name`. Throws DeviceError naming
    /// `backend` if it cannot be loaded; `remedy` says what to install.
    SharedLibrary(const char* backend, const char* variable, const char* name,
                  const std::string& remedy);

    /// Throws DeviceError if the library lacks the function.
    [[nodiscard]] Symbol find(const char* function) const;

    [[nodiscard]] const std::string& name() const { return name_; }

private:
    std::string backend_;
    std::string name_;
    std::unique_ptr<void, int (*)(void*)> handle_;
};

} // namespace zonegrid::device
