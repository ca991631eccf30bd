// SPDX-License-Identifier: MIT
#include "firmware/usb/descriptors.h"

#include <stddef.h>

namespace hedgehog::firmware {
namespace {

template <size_t kBytes>
struct Bytes {
  uint8_t at[kBytes] = {};
};

/// ASCII as UTF-16, with a header of `kHeader` bytes before it.
template <size_t kHeader, size_t kSize>
constexpr Bytes<kHeader + 2 * (kSize - 1)> wide(const char (&text)[kSize]) noexcept {
  Bytes<kHeader + 2 * (kSize - 1)> bytes;
  for (size_t i = 0; i + 1 < kSize; ++i) bytes.at[kHeader + 2 * i] = static_cast<uint8_t>(text[i]);
  return bytes;
}

template <size_t kSize>
constexpr auto string_descriptor(const char (&text)[kSize]) noexcept {
  auto bytes = wide<2>(text);
  bytes.at[0] = sizeof(bytes);
  bytes.at[1] = 3;
  return bytes;
}

// USB 2.1 because of the BOS descriptor; 1209:0001; firmware 1.02.
constexpr uint8_t kDevice[] = {18,   1,    0x10, 0x02, 0,    0, 0, 64, 0x09,
                               0x12, 0x01, 0x00, 0x02, 0x01, 1, 2, 3,  1};
constexpr uint8_t kConfiguration[] = {
    9, 2, 32,   0, 1,  1,    0,    0x80, 75,  // one interface, fed by the bus, 150 mA
    9, 4, 0,    0, 2,  0xFF, 0x48, 0x01, 0,   // the vendor's class, board protocol 01
    7, 5, 0x01, 2, 64, 0,    0,               // bulk OUT 01
    7, 5, 0x81, 2, 64, 0,    0};              // bulk IN 81
constexpr uint8_t kLanguages[] = {4, 3, 0x09, 0x04};
constexpr auto kManufacturer = string_descriptor("Hedgehog");
constexpr auto kProduct = string_descriptor("Hedgehog driver board");

// "Microsoft OS 2.0 Descriptors Specification", tables 4, 10, 13, 15.
constexpr auto kPropertyName = wide<0>("DeviceInterfaceGUIDs\0");
constexpr auto kPropertyValue = wide<0>("{7A1E3B52-5C0D-4F86-9B64-2E48D1A9C370}\0\0");
constexpr size_t kPropertyLength = 10 + sizeof(kPropertyName) + sizeof(kPropertyValue);
constexpr size_t kMicrosoftLength = 10 + 20 + kPropertyLength;

constexpr Bytes<kMicrosoftLength> microsoft() noexcept {
  constexpr uint8_t kHead[] = {10,   0,    0,
                               0,    0,    0,
                               0x03, 0x06, kMicrosoftLength,
                               0,  // from Windows 8.1 on
                               20,   0,    3,
                               0,    'W',  'I',
                               'N',  'U',  'S',
                               'B',  0,    0,
                               0,    0,    0,
                               0,    0,    0,
                               0,    0,    kPropertyLength,
                               0,    4,    0,
                               7,    0,    sizeof(kPropertyName),
                               0};
  Bytes<kMicrosoftLength> bytes;
  size_t length = 0;
  for (const uint8_t byte : kHead) bytes.at[length++] = byte;
  for (const uint8_t byte : kPropertyName.at) bytes.at[length++] = byte;
  bytes.at[length++] = sizeof(kPropertyValue);
  bytes.at[length++] = 0;
  for (const uint8_t byte : kPropertyValue.at) bytes.at[length++] = byte;
  return bytes;
}
constexpr auto kMicrosoft = microsoft();

constexpr uint8_t kBos[] = {
    5,
    15,
    33,
    0,
    1,  // one capability: the platform's, {D8DD60DF-4589-4CC7-9CD2-659D9E648A9F}
    28,
    16,
    5,
    0,
    0xDF,
    0x60,
    0xDD,
    0xD8,
    0x89,
    0x45,
    0xC7,
    0x4C,
    0x9C,
    0xD2,
    0x65,
    0x9D,
    0x9E,
    0x64,
    0x8A,
    0x9F,
    0,
    0,
    0x03,
    0x06,
    kMicrosoftLength,
    0,
    kMicrosoftRequest,
    0};

uint8_t serial_descriptor[2 + 2 * 31] = {2, 3};

constexpr uint8_t kTypeDevice = 1;
constexpr uint8_t kTypeConfiguration = 2;
constexpr uint8_t kTypeString = 3;
constexpr uint8_t kTypeBos = 15;

Descriptor string(uint8_t index) noexcept {
  switch (index) {
    case 0:
      return {kLanguages, sizeof(kLanguages)};
    case 1:
      return {kManufacturer.at, sizeof(kManufacturer)};
    case 2:
      return {kProduct.at, sizeof(kProduct)};
    case 3:
      return {serial_descriptor, serial_descriptor[0]};
    default:
      return {};
  }
}

}  // namespace

Descriptor descriptor(uint8_t type, uint8_t index) noexcept {
  if (type == kTypeString) return string(index);
  if (index != 0) return {};
  switch (type) {
    case kTypeDevice:
      return {kDevice, sizeof(kDevice)};
    case kTypeConfiguration:
      return {kConfiguration, sizeof(kConfiguration)};
    case kTypeBos:
      return {kBos, sizeof(kBos)};
    default:
      return {};
  }
}

Descriptor microsoft_descriptors() noexcept { return {kMicrosoft.at, sizeof(kMicrosoft)}; }

void set_serial(const char* text) noexcept {
  uint8_t length = 2;
  for (; *text != 0 && length < sizeof(serial_descriptor); ++text, length += 2)
    serial_descriptor[length] = static_cast<uint8_t>(*text);
  serial_descriptor[0] = length;
}

}  // namespace hedgehog::firmware
