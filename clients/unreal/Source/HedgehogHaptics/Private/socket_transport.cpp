// SPDX-License-Identifier: MIT
#include "socket_transport.h"

#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "AddressInfoTypes.h"
#include "CoreMinimal.h"
#include "IPAddress.h"
#include "SocketSubsystem.h"
#include "Sockets.h"

namespace {

using hedgehog::unreal::Transport;

/// The addresses of a name, resolved by a task of the engine: a name server may take seconds.
struct FHedgehogLookup {
  std::string Host;
  std::mutex Lock;
  std::optional<FAddressInfoResult> Found;

  bool IsDone() {
    const std::lock_guard<std::mutex> Guard(Lock);
    return Found.has_value();
  }
};

class FHedgehogTransport final : public Transport {
 public:
  FHedgehogTransport(ISocketSubsystem* InSubsystem, std::shared_ptr<FHedgehogLookup> InLookup,
                     std::uint16_t InPort)
      : Subsystem(InSubsystem), Lookup(std::move(InLookup)), Port(InPort) {}

  ~FHedgehogTransport() override { Destroy(); }

  State state() override {
    if (Lookup != nullptr) {
      if (!Lookup->IsDone()) return State::kConnecting;
      Found.emplace(*Lookup->Found);
      Lookup.reset();
      ConnectNext();
    }
    if (Socket == nullptr) return State::kEnded;
    const bool bFailed = Socket->GetConnectionState() == SCS_ConnectionError;
    if (bOpen) return bFailed ? State::kEnded : State::kOpen;
    if (!bFailed) bOpen = Socket->Wait(ESocketWaitConditions::WaitForWrite, FTimespan::Zero());
    if (bOpen) return State::kOpen;
    const bool bSilent = Next < Found->Results.Num() && FPlatformTime::Seconds() > AttemptEndS;
    if (bFailed || bSilent) {
      Destroy();
      ConnectNext();
    }
    return Socket != nullptr ? State::kConnecting : State::kEnded;
  }

  std::size_t send(std::string_view Bytes, bool& bEnded) override {
    int32 Sent = 0;
    if (Socket != nullptr && Socket->Send(reinterpret_cast<const uint8*>(Bytes.data()),
                                          static_cast<int32>(Bytes.size()), Sent))
      return static_cast<std::size_t>(Sent);
    bEnded = Socket == nullptr || !WouldBlock();
    return 0;
  }

  std::size_t receive(char* Bytes, std::size_t Size, bool& bEnded) override {
    int32 Read = 0;
    if (Socket != nullptr &&
        Socket->Recv(reinterpret_cast<uint8*>(Bytes), static_cast<int32>(Size), Read))
      return static_cast<std::size_t>(Read);
    // Without data Recv succeeds with zero bytes (FSocketBSD::Recv); a failure is the end.
    bEnded = true;
    return 0;
  }

 private:
  /// Time for an address that does not answer while there are others.
  static constexpr double AttemptS = 0.5;

  /// Begins with the next address of the name; without a socket none is left.
  void ConnectNext() {
    while (Socket == nullptr && Next < Found->Results.Num())
      Connect(Found->Results[Next++].Address);
  }

  void Connect(const TSharedRef<FInternetAddr>& Remote) {
    AttemptEndS = FPlatformTime::Seconds() + AttemptS;
    Remote->SetPort(Port);
    Socket = Subsystem->CreateSocket(NAME_Stream, TEXT("Hedgehog"), Remote->GetProtocolType());
    if (Socket == nullptr) return;
    Socket->SetNonBlocking(true);
    // Small lines would be delayed by up to 40 ms.
    Socket->SetNoDelay(true);
    if (!Socket->Connect(*Remote) && !WouldBlock()) Destroy();
  }

  bool WouldBlock() const {
    const ESocketErrors Error = Subsystem->GetLastErrorCode();
    return Error == SE_EWOULDBLOCK || Error == SE_EINPROGRESS;
  }

  void Destroy() {
    if (Socket == nullptr) return;
    Socket->Close();
    Subsystem->DestroySocket(Socket);
    Socket = nullptr;
  }

  ISocketSubsystem* Subsystem;
  /// Null once the addresses are resolved.
  std::shared_ptr<FHedgehogLookup> Lookup;
  std::optional<FAddressInfoResult> Found;
  /// Index in Found of the next address.
  int32 Next = 0;
  double AttemptEndS = 0.0;
  std::uint16_t Port;
  FSocket* Socket = nullptr;
  bool bOpen = false;
};

/// Attempts to connect to one name share the look-up in progress, so that a silent name server
/// occupies only one of the engine's threads.
class FHedgehogConnector {
 public:
  std::unique_ptr<Transport> operator()(const hedgehog::unreal::Address& Place) {
    ISocketSubsystem* const Subsystem = ISocketSubsystem::Get(PLATFORM_SOCKETSUBSYSTEM);
    if (Last == nullptr || Last->Host != Place.host || Last->IsDone())
      Last = Start(*Subsystem, Place.host);
    return std::make_unique<FHedgehogTransport>(Subsystem, Last, Place.port);
  }

 private:
  static std::shared_ptr<FHedgehogLookup> Start(ISocketSubsystem& Subsystem,
                                                const std::string& Host) {
    auto Lookup = std::make_shared<FHedgehogLookup>();
    Lookup->Host = Host;
    Subsystem.GetAddressInfoAsync(
        [Lookup](FAddressInfoResult Found) {
          const std::lock_guard<std::mutex> Guard(Lookup->Lock);
          Lookup->Found.emplace(std::move(Found));
        },
        UTF8_TO_TCHAR(Host.c_str()), nullptr, EAddressInfoFlags::Default, NAME_None,
        SOCKTYPE_Streaming);
    return Lookup;
  }

  std::shared_ptr<FHedgehogLookup> Last;
};

}  // namespace

hedgehog::unreal::Connect HedgehogConnector() { return FHedgehogConnector(); }
