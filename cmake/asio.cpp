// SPDX-License-Identifier: MIT
// The one translation unit that holds Asio's code; everybody else sees declarations only.

#include <boost/asio/impl/src.hpp>
