// SPDX-License-Identifier: MIT
#include "tests/sdk/unreal/engine_stub.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <thread>

#include "tests/sdk/unreal/sockets_stub.h"

std::string stub_utf8(const TCHAR* text) {
  std::string out;
  const auto add = [&out](unsigned byte) { out += static_cast<char>(byte); };
  for (; *text != 0; ++text) {
    unsigned code = *text;
    if (code >= 0xD800 && code < 0xDC00)
      code = 0x10000 + ((code - 0xD800) << 10) + (*++text - 0xDC00u);
    if (code < 0x80) {
      add(code);
      continue;
    }
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    add((more == 1 ? 0xC0u : more == 2 ? 0xE0u : 0xF0u) | (code >> (6 * more)));
    for (int i = more - 1; i >= 0; --i) add(0x80 | ((code >> (6 * i)) & 0x3F));
  }
  return out;
}

std::u16string stub_utf16(const char* text) {
  std::u16string out;
  while (*text != 0) {
    const auto first = static_cast<unsigned char>(*text++);
    const int more = first < 0x80 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
    unsigned code = more == 0 ? first : first & (0x3Fu >> more);
    for (int i = 0; i < more; ++i)
      code = (code << 6) | (static_cast<unsigned char>(*text++) & 0x3Fu);
    if (code >= 0x10000) {
      out += static_cast<char16_t>(0xD800 + ((code - 0x10000) >> 10));
      code = 0xDC00 + ((code - 0x10000) & 0x3FF);
    }
    out += static_cast<char16_t>(code);
  }
  return out;
}

void stub_log(const char* category, const TCHAR* format, const TCHAR* a, const TCHAR* b) {
  // The formats of the plugin are "%s" and "%s: %s".
  const bool two = stub_utf8(format) == "%s: %s";
  std::printf("%s: Warning: %s%s%s\n", category, stub_utf8(a).c_str(), two ? ": " : "",
              two ? stub_utf8(b).c_str() : "");
}

void FInternetAddr::SetPort(int32 port) {
  const auto value = htons(static_cast<std::uint16_t>(port));
  // The port is at the same offset in sockaddr_in and sockaddr_in6.
  std::memcpy(bytes_.data() + offsetof(sockaddr_in, sin_port), &value, sizeof value);
}

FSocket::~FSocket() { Close(); }

bool FSocket::SetNonBlocking(bool) { return true; }

bool FSocket::SetNoDelay(bool) { return true; }

bool FSocket::Connect(const FInternetAddr& address) {
  sockaddr_storage storage{};
  std::memcpy(&storage, address.bytes().data(), address.bytes().size());
  descriptor_ = socket(storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int on = 1;
  setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return connect(descriptor_, reinterpret_cast<const sockaddr*>(&storage),
                 static_cast<socklen_t>(address.bytes().size())) == 0;
}

ESocketConnectionState FSocket::GetConnectionState() {
  pollfd one{descriptor_, POLLOUT, 0};
  poll(&one, 1, 0);
  if (!connected_ && (one.revents & POLLERR) != 0) return SCS_ConnectionError;
  connected_ = connected_ || (one.revents & POLLOUT) != 0;
  return connected_ ? SCS_Connected : SCS_NotConnected;
}

bool FSocket::Wait(ESocketWaitConditions condition, FTimespan) {
  const short events = condition == ESocketWaitConditions::WaitForWrite ? POLLOUT : POLLIN;
  pollfd one{descriptor_, events, 0};
  return poll(&one, 1, 0) == 1 && (one.revents & events) != 0;
}

bool FSocket::Send(const uint8* data, int32 count, int32& sent) {
  const ssize_t result = send(descriptor_, data, static_cast<std::size_t>(count), MSG_NOSIGNAL);
  sent = static_cast<int32>(result);
  return result >= 0;
}

// True with `read` 0: no data available; false: end of the stream, or an error.
bool FSocket::Recv(uint8* data, int32 size, int32& read) {
  const ssize_t result = recv(descriptor_, data, static_cast<std::size_t>(size), 0);
  read = result > 0 ? static_cast<int32>(result) : 0;
  return result > 0 || (result < 0 && (errno == EAGAIN || errno == EWOULDBLOCK));
}

bool FSocket::Close() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
  return true;
}

ISocketSubsystem* ISocketSubsystem::Get(FName) {
  static ISocketSubsystem system;
  return &system;
}

static FAddressInfoResult addresses_of(const std::string& host) {
  FAddressInfoResult found;
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* list = nullptr;
  if (getaddrinfo(host.c_str(), nullptr, &hints, &list) != 0) return found;
  for (const addrinfo* one = list; one != nullptr; one = one->ai_next) {
    const auto* first = reinterpret_cast<const std::byte*>(one->ai_addr);
    found.Results.push_back(
        {std::make_shared<FInternetAddr>(std::vector<std::byte>(first, first + one->ai_addrlen))});
  }
  freeaddrinfo(list);
  return found;
}

void ISocketSubsystem::GetAddressInfoAsync(std::function<void(FAddressInfoResult)> found,
                                           const TCHAR* host, const TCHAR*, EAddressInfoFlags,
                                           FName, ESocketType) {
  std::thread([found = std::move(found), host = stub_utf8(host)] {
    found(addresses_of(host));
  }).detach();
}

FSocket* ISocketSubsystem::CreateSocket(FName, const FString&, FName) { return new FSocket; }

ESocketErrors ISocketSubsystem::GetLastErrorCode() {
  if (errno == EAGAIN || errno == EWOULDBLOCK) return SE_EWOULDBLOCK;
  if (errno == EINPROGRESS) return SE_EINPROGRESS;
  return errno == 0 ? SE_NO_ERROR : SE_ECONNREFUSED;
}
