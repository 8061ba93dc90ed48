// SPDX-License-Identifier: GPL-3.0-or-later
// The errors that a user can cause, each with what happened, where, and what to do about it.
// Programming errors are asserted instead.
#pragma once

#include <stdexcept>
#include <string>

namespace hepatica {

// Base of every error that reaches the user.
//   problem: what is wrong, with the offending value ("slice 12 is missing")
//   place:   file, line, tag or option it was found in; may be empty
//   remedy:  what the user can do now
class Error : public std::runtime_error {
  public:
    Error(std::string problem, std::string place, std::string remedy);

    const std::string& problem() const { return problem_; }
    const std::string& place() const { return place_; }
    const std::string& remedy() const { return remedy_; }

  private:
    std::string problem_;
    std::string place_;
    std::string remedy_;
};

// The input (a file, a folder, a value in it) cannot be used. Exit code 1.
class InputError : public Error {
    using Error::Error;
};

// The command line or the call was not understood. Exit code 2.
class UsageError : public Error {
    using Error::Error;
};

// A job was cancelled by its user. Not a failure: nothing is left behind.
class Cancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace hepatica
