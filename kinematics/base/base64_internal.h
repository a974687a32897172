// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace gaitwright {

/// Base64 (RFC 4648) of bytes.
std::string Base64(std::string_view bytes);

/// The bytes of a text in base64. Other characters, such as line ends and padding, are left out.
std::string FromBase64(std::string_view text);

}  // namespace gaitwright
