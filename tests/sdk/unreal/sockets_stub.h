// SPDX-License-Identifier: MIT
// The part of Unreal's sockets that the plugin uses, based on this machine's sockets, with the same
// results as FSocketBSD.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "tests/sdk/unreal/engine_stub.h"

enum ESocketErrors { SE_NO_ERROR, SE_EWOULDBLOCK, SE_EINPROGRESS, SE_ECONNREFUSED };
enum ESocketConnectionState { SCS_NotConnected, SCS_Connected, SCS_ConnectionError };
enum ESocketType { SOCKTYPE_Unknown, SOCKTYPE_Datagram, SOCKTYPE_Streaming };
enum class ESocketWaitConditions { WaitForRead, WaitForWrite };
enum class EAddressInfoFlags { Default };
enum FName { NAME_None, NAME_Stream, NAME_Protocol };
struct FTimespan {
  static FTimespan Zero() { return {}; }
};

class FInternetAddr {
 public:
  explicit FInternetAddr(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}
  void SetPort(int32 port);
  FName GetProtocolType() const { return NAME_Protocol; }
  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};
template <class T>
using TSharedRef = std::shared_ptr<T>;

class FSocket {
 public:
  ~FSocket();
  bool SetNonBlocking(bool value);
  bool SetNoDelay(bool value);
  bool Connect(const FInternetAddr& address);
  ESocketConnectionState GetConnectionState();
  bool Wait(ESocketWaitConditions condition, FTimespan time);
  bool Send(const uint8* data, int32 count, int32& sent);
  bool Recv(uint8* data, int32 size, int32& read);
  bool Close();

 private:
  int descriptor_ = -1;
  bool connected_ = false;
};

struct FAddressInfoResult {
  struct Result {
    TSharedRef<FInternetAddr> Address;
  };
  struct Array : std::vector<Result> {
    int32 Num() const { return static_cast<int32>(size()); }
  };
  Array Results;
};

#define PLATFORM_SOCKETSUBSYSTEM NAME_None
class ISocketSubsystem {
 public:
  static ISocketSubsystem* Get(FName name);
  /// `found` is called on one of the engine's threads.
  void GetAddressInfoAsync(std::function<void(FAddressInfoResult)> found, const TCHAR* host,
                           const TCHAR* service, EAddressInfoFlags flags, FName protocol,
                           ESocketType type);
  FSocket* CreateSocket(FName type, const FString& description, FName protocol);
  void DestroySocket(FSocket* socket) { delete socket; }
  ESocketErrors GetLastErrorCode();
};
