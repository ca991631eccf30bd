// SPDX-License-Identifier: MIT
// The emulator's endpoints: hosts that list and import devices, and clients that send commands.
#include "emulator/server.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/un.h>

#include <thread>

#include "emulator/device_text.h"
#include "tests/temporary_folder.h"

namespace hedgehog::emulator {
namespace {

using device::FileDescriptor;
using testing::HasSubstr;

class EmulatorServer : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* text : {"board,serial=B7", "mti,unplugged"}) {
      auto made = make_device(text);
      hub_.add(made.name, std::move(made.device));
      if (made.plugged) hub_.execute("plug " + made.name);
    }
    auto imports = listen_tcp("127.0.0.1:0");
    port_ = port_of(imports.get());
    server_.emplace(hub_, std::move(imports), listen_unix(path_), false);
    thread_ = std::thread([this] { server_->run(stop_); });
  }
  void TearDown() override {
    EXPECT_EQ(command("quit"), "ok");
    thread_.join();
  }

  FileDescriptor host() const {
    FileDescriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket.get(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    const timeval timeout{30, 0};
    ::setsockopt(socket.get(), SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof timeout);
    return socket;
  }

  std::string command(const std::string& line) const {
    const FileDescriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path_.copy(address.sun_path, sizeof address.sun_path - 1);
    EXPECT_EQ(::connect(socket.get(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    send(socket, line + "\n");
    std::string response;
    for (char c = 0; ::recv(socket.get(), &c, 1, 0) == 1 && c != '\n';) response += c;
    return response;
  }

  static void send(const FileDescriptor& socket, const std::string& bytes) {
    EXPECT_EQ(::send(socket.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }
  static std::string receive(const FileDescriptor& socket, std::size_t size) {
    std::string bytes(size, '\0');
    const ssize_t got = ::recv(socket.get(), bytes.data(), size, MSG_WAITALL);
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
  }
  static std::string import_request(std::string bus_id) {
    bus_id.resize(kBusId);
    return std::string("\x01\x11\x80\x03\0\0\0\0", 8) + bus_id;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.path("usbip.sock");
  Hub hub_{std::nullopt};
  std::optional<Server> server_;
  volatile std::sig_atomic_t stop_ = 0;
  std::thread thread_;
  int port_ = 0;
};

constexpr std::size_t kDeviceBytes = 312;

TEST_F(EmulatorServer, ListsPluggedDevices) {
  const auto list = [this] {
    const FileDescriptor socket = host();
    send(socket, std::string("\x01\x11\x80\x05\0\0\0\0", 8));
    return receive(socket, 4096);
  };
  const std::string one = list();
  ASSERT_EQ(one.size(), 12 + kDeviceBytes + 4);
  EXPECT_EQ(one.substr(0, 12), std::string("\x01\x11\0\x05\0\0\0\0\0\0\0\x01", 12));
  EXPECT_EQ(one.substr(12 + 256, 4), std::string("1-1\0", 4));
  EXPECT_EQ(one.substr(12 + 300, 4), std::string("\x12\x09\0\x01", 4));
  EXPECT_EQ(command("plug mti"), "ok");
  EXPECT_EQ(list().size(), 12 + 2 * (kDeviceBytes + 4));
}

TEST_F(EmulatorServer, ImportsADeviceForOneHostAtATime) {
  const std::string refused("\x01\x11\0\x03\0\0\0\x01", 8);
  const FileDescriptor socket = host();
  send(socket, import_request("1-1"));
  ASSERT_EQ(receive(socket, 8 + kDeviceBytes).size(), 8 + kDeviceBytes);
  for (const char* bus_id : {"1-1", "1-2", "9-9"}) {
    const FileDescriptor other = host();
    send(other, import_request(bus_id));
    EXPECT_EQ(receive(other, 4096), refused) << bus_id;
  }
  // A request directly after the import is for the device: its serial number.
  Bytes question;
  for (const std::uint32_t word : {1u, 1u, 0u, 1u, 0u, 0u, 255u, 0u, 0u, 0u})
    put_u32(question, word);
  question.insert(question.end(), {0x80, 6, 3, 3, 0x09, 0x04, 255, 0});
  send(socket, std::string(question.begin(), question.end()));
  EXPECT_EQ(receive(socket, kTransferHead + 6).substr(kTransferHead),
            std::string("\x06\x03\x42\0\x37\0", 6));
  EXPECT_EQ(command("unplug board"), "ok");
  EXPECT_EQ(receive(socket, 1), "") << "the cable is out";
}

TEST_F(EmulatorServer, RunsCommandsAndReportsErrors) {
  EXPECT_THAT(command("list"), HasSubstr(R"("serial": "B7", "plugged": true)"));
  EXPECT_THAT(command("status board"), HasSubstr(R"("mode": "safe")"));
  EXPECT_EQ(command("stall board 81 3"), "ok");
  EXPECT_THAT(command("stall board 80"), HasSubstr("error: stall DEVICE ENDPOINT"));
  EXPECT_EQ(command("plug board"), "error: board is plugged in already");
  EXPECT_EQ(command("unplug mti"), "error: mti is not plugged in");
  EXPECT_EQ(command("turn mti 1 0 0 0"), "ok");
  EXPECT_EQ(command("turn mti 0 0 0 0"), "error: turn W X Y Z, not all of them 0");
  EXPECT_EQ(command("turn board 1 0 0 0"), "error: board has no command turn");
  EXPECT_EQ(command("plug fridge"), "error: no device fridge");
  EXPECT_EQ(command(""), "error: no command");
}

TEST(DeviceText, NamesTheProblem) {
  EXPECT_EQ(make_device("board,name=b,unplugged").name, "b");
  EXPECT_FALSE(make_device("board,unplugged").plugged);
  EXPECT_THAT(make_device("toaster").failure, HasSubstr("there are: board, mti"));
  EXPECT_EQ(make_device("board,colour=red").failure, "unknown: colour=red");
  EXPECT_EQ(make_device("board,start=hot").failure, "start=hot: not a temperature");
  EXPECT_THAT(make_device("firmware-board,serial=B2").failure, HasSubstr("its own serial number"));
  EXPECT_EQ(make_device("").failure, "no kind of device");
}

TEST(VhciPorts, AreReportedAsMissing) {
  Hub hub(Vhci("/nowhere"));
  hub.add("board", make_device("board").device);
  EXPECT_THAT(hub.execute("plug board"), HasSubstr("modprobe vhci-hcd"));
}

}  // namespace
}  // namespace hedgehog::emulator
