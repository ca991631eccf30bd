// SPDX-License-Identifier: MIT
// The one translation unit with Asio's code; all others include its declarations only.

#include <boost/asio/impl/src.hpp>
