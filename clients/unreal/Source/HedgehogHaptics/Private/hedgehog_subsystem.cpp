// SPDX-License-Identifier: MIT
#include "hedgehog_subsystem.h"

#include <string>
#include <utility>

#include "Stats/Stats.h"
#include "core/client.h"
#include "core/methods.h"
#include "hedgehog_effect_json.h"
#include "hedgehog_message_json.h"
#include "socket_transport.h"

DEFINE_LOG_CATEGORY_STATIC(LogHedgehog, Log, All);

namespace {

using hedgehog::unreal::Answer;
using hedgehog::unreal::Json;
namespace methods = hedgehog::unreal::methods;

std::string ToUtf8(const FString& Text) { return std::string(TCHAR_TO_UTF8(*Text)); }
FString FromUtf8(const std::string& Text) { return FString(UTF8_TO_TCHAR(Text.c_str())); }

/// The ball's axes are x front, y left, z up.
Json ToJson(const FVector& Direction) {
  return Json::array({Direction.X, -Direction.Y, Direction.Z});
}

template <class TEffect>
Json With(const char* Name, Json Value, const TEffect& Effect) {
  Json Params = HedgehogToJson(Effect);
  Params.set(Name, std::move(Value));
  return Params;
}

FHedgehogAnswer ToAnswer(const FString& Method, const Answer& Came) {
  FHedgehogAnswer Report;
  Report.bOk = Came.ok();
  Report.Method = Method;
  if (Came.ok()) Report.Result = FromUtf8(Came.result.to_text());
  Report.Message = FromUtf8(Came.message);
  Report.Error = HedgehogErrorOf(Came.code);
  Report.Code = Came.code;
  Report.Name = FromUtf8(Came.name);
  Report.Field = FromUtf8(Came.data["field"].text());
  return Report;
}

template <class TMessage>
TMessage To(const Json& Params) {
  TMessage Message;
  Read(Params, Message);
  return Message;
}

}  // namespace

void UHedgehogSubsystem::Initialize(FSubsystemCollectionBase& Collection) {
  Super::Initialize(Collection);
  hedgehog::unreal::Settings Settings;
  Settings.address = ToUtf8(Address);
  Settings.timeout_s = static_cast<double>(TimeoutS);
  hedgehog::unreal::Listeners Listeners;
  Listeners.connected = [this](const Json&) { OnConnected.Broadcast(); };
  Listeners.disconnected = [this](const std::string& Reason) {
    const FString Sentence = FromUtf8(Reason);
    UE_LOG(LogHedgehog, Warning, TEXT("%s"), *Sentence);
    OnDisconnected.Broadcast(Sentence);
  };
  Listeners.notification = [this](const std::string& Method, const Json& Params) {
    if (Method == "event") OnEvent.Broadcast(To<FHedgehogEvent>(Params));
    if (Method == "telemetry") OnStatus.Broadcast(To<FHedgehogStatus>(Params));
  };
  Listeners.subscription_ended = [this](const std::string& Method, const Answer& Came) {
    Refuse(Method.c_str(), Came);
  };
  Client = std::make_shared<hedgehog::unreal::Client>(std::move(Settings), HedgehogConnector(),
                                                      std::move(Listeners));
}

void UHedgehogSubsystem::Deinitialize() {
  if (Client != nullptr) Client->close();
  Client.reset();
  Super::Deinitialize();
}

void UHedgehogSubsystem::Tick(float) {
  // A listener may end the game, and with it this object.
  const std::shared_ptr<hedgehog::unreal::Client> Polled = Client;
  if (Polled != nullptr) Polled->poll(FPlatformTime::Seconds());
}

TStatId UHedgehogSubsystem::GetStatId() const {
  RETURN_QUICK_DECLARE_CYCLE_STAT(UHedgehogSubsystem, STATGROUP_Tickables);
}

bool UHedgehogSubsystem::IsBallConnected() const { return Client != nullptr && Client->is_open(); }

float UHedgehogSubsystem::FeltA() const { return Limit("felt_a"); }

float UHedgehogSubsystem::FullA() const { return Limit("current_a"); }

float UHedgehogSubsystem::Limit(const char* Name) const {
  return Client == nullptr ? 0.0f : static_cast<float>(Client->hello()["limits"][Name].number());
}

bool UHedgehogSubsystem::Rumble(const FString& Slot, float Strength, FVector Direction,
                                float FrequencyHz) {
  FHedgehogEffect Effect;
  Effect.FrequencyHz = FrequencyHz;
  return RumbleWith(Slot, Strength, Direction, Effect);
}

bool UHedgehogSubsystem::RumbleWith(const FString& Slot, float Strength, FVector Direction,
                                    const FHedgehogEffect& Effect) {
  FHedgehogEffect Further = Effect;
  Further.CurrentA = -1.0f;
  Further.ForceN = -1.0f;
  Further.DurationMs = -1.0f;
  return Client != nullptr && Client->rumble(ToUtf8(Slot), static_cast<double>(Strength),
                                             ToJson(Direction), HedgehogToJson(Further));
}

void UHedgehogSubsystem::Pulse(FVector Direction, const FHedgehogEffect& Effect) {
  Start(methods::kEffectPulse, With("direction", ToJson(Direction), Effect));
}

void UHedgehogSubsystem::Vibrate(FVector Direction, const FHedgehogEffect& Effect) {
  Start(methods::kEffectVibrate, With("direction", ToJson(Direction), Effect));
}

void UHedgehogSubsystem::Hold(FVector Direction, const FHedgehogEffect& Effect) {
  Start(methods::kEffectHold, With("direction", ToJson(Direction), Effect));
}

void UHedgehogSubsystem::Circle(FVector Axis, const FHedgehogCircle& Effect) {
  Start(methods::kEffectCircle, With("axis", ToJson(Axis), Effect));
}

void UHedgehogSubsystem::Play(const FString& Pattern, const FHedgehogPlay& Effect) {
  Start(methods::kEffectPlay, With("pattern", ToUtf8(Pattern), Effect));
}

void UHedgehogSubsystem::Stop(const FString& Slot) {
  Start(methods::kEffectStop, Json::object({{"slot", ToUtf8(Slot)}}));
}

void UHedgehogSubsystem::StopAll() { Start(methods::kEffectStopAll, Json::object()); }

void UHedgehogSubsystem::SubscribeEvents(bool bOfAll) {
  Start(methods::kEventsSubscribe, Json::object({{"scope", bOfAll ? "all" : "mine"}}));
}

void UHedgehogSubsystem::SubscribeStatus(float RateHz) {
  Start(methods::kTelemetrySubscribe, Json::object({{"rate_hz", static_cast<double>(RateHz)}}));
}

void UHedgehogSubsystem::UnsubscribeEvents() { Start(methods::kEventsUnsubscribe, Json::object()); }

void UHedgehogSubsystem::UnsubscribeStatus() {
  Start(methods::kTelemetryUnsubscribe, Json::object());
}

void UHedgehogSubsystem::Request(const FString& Method, const FString& Params,
                                 const FHedgehogAnswered& Answered) {
  Ask(
      Method, Params,
      [Answered](const FHedgehogAnswer& Answer) { Answered.ExecuteIfBound(Answer); });
}

void UHedgehogSubsystem::Ask(const FString& Method, const FString& Params,
                             std::function<void(const FHedgehogAnswer&)> Answered) {
  if (Client == nullptr) return;
  const std::string Text = ToUtf8(Params);
  const std::optional<Json> Object = Json::parse(Text.empty() ? "{}" : Text);
  if (!Object || !Object->is(Json::Kind::kObject)) {
    Answered(ToAnswer(Method, hedgehog::unreal::failed(hedgehog::unreal::Failure::kBadValue,
                                                       "the parameters are no JSON object")));
    return;
  }
  Client->request(ToUtf8(Method), *Object,
                  [Method, Answered](const Answer& Came) { Answered(ToAnswer(Method, Came)); });
}

void UHedgehogSubsystem::Start(const char* Method, const Json& Params) {
  if (Client == nullptr) return;
  Client->request(Method, Params, [this, Method](const Answer& Came) {
    if (!Came.ok()) Refuse(Method, Came);
  });
}

void UHedgehogSubsystem::Refuse(const char* Method, const Answer& Came) {
  const FHedgehogAnswer Report = ToAnswer(FString(UTF8_TO_TCHAR(Method)), Came);
  UE_LOG(LogHedgehog, Warning, TEXT("%s: %s"), *Report.Method, *Report.Message);
  OnRefused.Broadcast(Report);
}
