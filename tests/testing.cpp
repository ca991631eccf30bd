// SPDX-License-Identifier: MIT
// Owns the precompiled test headers. GoogleTest must come first: RapidCheck's GoogleTest header
// depends on it.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
