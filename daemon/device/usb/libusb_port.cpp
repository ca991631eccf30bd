// SPDX-License-Identifier: MIT
#include "daemon/device/usb/libusb_port.h"

#include <algorithm>
#include <array>
#include <utility>

#include "daemon/device/usb/usb_handle.h"

namespace hedgehog::device {
namespace {

constexpr std::chrono::milliseconds kClosing{1000};
constexpr std::chrono::milliseconds kClosePoll{50};

TransferEnd end_of(libusb_transfer_status status) noexcept {
  switch (status) {
    case LIBUSB_TRANSFER_COMPLETED:
      return TransferEnd::kDone;
    case LIBUSB_TRANSFER_CANCELLED:
      return TransferEnd::kCancelled;
    case LIBUSB_TRANSFER_STALL:
      return TransferEnd::kStalled;
    case LIBUSB_TRANSFER_NO_DEVICE:
      return TransferEnd::kGone;
    case LIBUSB_TRANSFER_ERROR:
    case LIBUSB_TRANSFER_TIMED_OUT:
    case LIBUSB_TRANSFER_OVERFLOW:
      break;
  }
  return TransferEnd::kFailed;
}

class LibusbPort;

struct Slot {
  LibusbPort* port = nullptr;
  int number = 0;
  bool submitted = false;
  libusb_transfer* transfer = nullptr;
  std::array<std::uint8_t, kSlotBytes> bytes{};
};

/// Memory that libusb writes to; outlives its port only if a transfer never ends.
struct Slots : std::array<Slot, kSlots> {
  Slots() : std::array<Slot, kSlots>{} {}
  Slots(const Slots&) = delete;
  Slots& operator=(const Slots&) = delete;
  ~Slots() {
    for (Slot& slot : *this) libusb_free_transfer(slot.transfer);
  }
};

class LibusbPort : public UsbPort {
 public:
  explicit LibusbPort(std::unique_ptr<UsbHandle> usb)
      : usb_(std::move(usb)), slots_(std::make_unique<Slots>()) {}

  /// False: out of memory.
  bool prepare() noexcept {
    for (int i = 0; i < kSlots; ++i) {
      Slot& slot = at(i);
      slot.port = this;
      slot.number = i;
      slot.transfer = libusb_alloc_transfer(0);
      if (slot.transfer == nullptr) return false;
      const UsbHandle::Endpoints& ends = usb_->endpoints();
      libusb_fill_bulk_transfer(slot.transfer, usb_->get(), i < kReadSlots ? ends.in : ends.out,
                                slot.bytes.data(), static_cast<int>(kSlotBytes), &ended, &slot, 0);
    }
    return true;
  }

  ~LibusbPort() override {
    for (int i = 0; i < kSlots; ++i) cancel(i);
    std::array<Completion, kSlots> ignored;
    for (auto left = kClosing; busy() && left.count() > 0; left -= kClosePoll)
      (void)poll(ignored, kClosePoll);
    if (!busy()) return;
    // The kernel still uses them: a memory leak is better than a write after free.
    (void)slots_.release();
    (void)usb_.release();
  }

  std::span<std::uint8_t, kSlotBytes> buffer(int slot) noexcept override { return at(slot).bytes; }

  bool submit(int number, std::size_t length) noexcept override {
    Slot& slot = at(number);
    slot.transfer->length = static_cast<int>(number < kReadSlots ? kSlotBytes : length);
    slot.submitted = libusb_submit_transfer(slot.transfer) == 0;
    return slot.submitted;
  }

  void cancel(int number) noexcept override {
    Slot& slot = at(number);
    if (slot.submitted) (void)libusb_cancel_transfer(slot.transfer);
  }

  std::size_t poll(std::span<Completion> into, std::chrono::milliseconds wait) noexcept override {
    if (count_ == 0) {
      timeval time{0, static_cast<suseconds_t>(wait.count()) * 1000};
      (void)libusb_handle_events_timeout_completed(usb_->context(), &time, nullptr);
    }
    const std::size_t taken = std::min(count_, into.size());
    std::copy_n(ended_.begin(), taken, into.begin());
    std::copy(ended_.begin() + static_cast<std::ptrdiff_t>(taken),
              ended_.begin() + static_cast<std::ptrdiff_t>(count_), ended_.begin());
    count_ -= taken;
    return taken;
  }

  bool clear_halt() noexcept override {
    const UsbHandle::Endpoints& ends = usb_->endpoints();
    const bool in = libusb_clear_halt(usb_->get(), ends.in) == 0;
    return libusb_clear_halt(usb_->get(), ends.out) == 0 && in;
  }

 private:
  Slot& at(int slot) noexcept { return (*slots_)[static_cast<std::size_t>(slot)]; }
  bool busy() const noexcept {
    return std::any_of(
        slots_->begin(), slots_->end(), [](const Slot& s) { return s.submitted; });
  }

  static void LIBUSB_CALL ended(libusb_transfer* transfer) {
    Slot& slot = *static_cast<Slot*>(transfer->user_data);
    slot.submitted = false;
    // A slot ends once before it is submitted again, so there is capacity for each.
    LibusbPort& port = *slot.port;
    if (port.count_ == port.ended_.size()) return;
    port.ended_[port.count_++] = {slot.number, end_of(transfer->status),
                                  static_cast<std::size_t>(transfer->actual_length)};
  }

  std::unique_ptr<UsbHandle> usb_;
  std::unique_ptr<Slots> slots_;
  std::array<Completion, kSlots> ended_{};
  std::size_t count_ = 0;
};

class LibusbBus : public UsbBus {
 public:
  std::vector<UsbDevice> list() override { return list_usb(); }
  std::unique_ptr<UsbPort> open(const UsbPlace& place, std::string& failure) override {
    auto usb = UsbHandle::open(place, LIBUSB_TRANSFER_TYPE_BULK, true, failure);
    if (!usb) return nullptr;
    auto port = std::make_unique<LibusbPort>(std::move(usb));
    if (!port->prepare()) {
      failure = "no memory for its transfers";
      return nullptr;
    }
    return port;
  }
};

}  // namespace

std::unique_ptr<UsbBus> make_libusb_bus() { return std::make_unique<LibusbBus>(); }

}  // namespace hedgehog::device
