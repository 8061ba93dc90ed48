// SPDX-License-Identifier: GPL-3.0-or-later
// Integers from JSON with range checks. The library's get<int>() truncates values that do not fit,
// and its result for a decimal out of range is undefined.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace hepatica {

// Throws Json::exception, as get<T>() does for a string, if the value is not an integer or does not
// fit into T. 3.0 counts as an integer.
template <std::integral T, class Json>
T whole_number(const Json& value) {
    constexpr double exact = 0x1p53;  // up to here a double represents every integer
    if (value.is_number_unsigned()) {
        const auto number = value.template get<std::uint64_t>();
        if (std::in_range<T>(number)) return static_cast<T>(number);
    } else if (value.is_number_integer()) {
        const auto number = value.template get<std::int64_t>();
        if (std::in_range<T>(number)) return static_cast<T>(number);
    } else if (value.is_number_float()) {
        const auto number = value.template get<double>();
        if (std::abs(number) <= exact && number == std::trunc(number) &&
            std::in_range<T>(static_cast<std::int64_t>(number)))
            return static_cast<T>(number);
    }
    throw nlohmann::detail::type_error::create(
        302, "must be a whole number in range, but is " + value.dump(), &value);
}

template <std::integral T, class Json>
std::vector<T> whole_numbers(const Json& values) {
    std::vector<T> numbers;
    for (const Json& value : values) numbers.push_back(whole_number<T>(value));
    return numbers;
}

}  // namespace hepatica
