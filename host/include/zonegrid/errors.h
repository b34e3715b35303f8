#pragma once

#include <stdexcept>
#include <string>

namespace zonegrid {

/// Base of everything the library throws on purpose.
/// `what()` is one sentence for a person: what is wrong, where, and the remedy.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A value handed in by the caller cannot work (option out of range, contradiction).
/// The command line maps it to exit code 2.
class UsageError : public Error {
public:
    using Error::Error;
};

/// Data that was read is wrong: `where` names the file and, where there is one, the line or field.
class InputError : public Error {
public:
    InputError(const std::string& where, const std::string& problem, const std::string& remedy)
        : Error(where + ": " + problem + "; " + remedy) {}
};

/// The model's integers or the machine's memory cannot hold what was asked for.
class CapacityError : public Error {
public:
    using Error::Error;
};

/// A device or its driver cannot do what was asked: `device` is its name as `list_devices` gives
/// it, `problem` the call that failed and its code by name.
class DeviceError : public Error {
public:
    DeviceError(const std::string& device, const std::string& problem, const std::string& remedy)
        : Error(device + ": " + problem + "; " + remedy) {}
};

/// Something could not be written; nothing half-written is left behind.
class OutputError : public Error {
public:
    using Error::Error;
};

} // namespace zonegrid
