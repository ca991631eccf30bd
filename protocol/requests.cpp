// SPDX-License-Identifier: MIT
#include "protocol/requests.h"

#include "protocol/describe.h"

namespace hedgehog::protocol {
namespace {

struct MethodOf {
  Method operator()(const Hello&) const { return Method::kHello; }
  Method operator()(const Ping&) const { return Method::kPing; }
  Method operator()(const EffectStart& start) const { return start.method; }
  Method operator()(const EffectUpdate&) const { return Method::kEffectUpdate; }
  Method operator()(const EffectStop&) const { return Method::kEffectStop; }
  Method operator()(const EffectStopAll&) const { return Method::kEffectStopAll; }
  Method operator()(const DeviceDescribe&) const { return Method::kDeviceDescribe; }
  Method operator()(const DeviceList&) const { return Method::kDeviceList; }
  Method operator()(const DeviceStatus&) const { return Method::kDeviceStatus; }
  Method operator()(const DeviceEmergencyStop&) const { return Method::kDeviceEmergencyStop; }
  Method operator()(const DeviceArm&) const { return Method::kDeviceArm; }
  Method operator()(const DeviceClaim&) const { return Method::kDeviceClaim; }
  Method operator()(const DeviceRelease&) const { return Method::kDeviceRelease; }
  Method operator()(const OutputSetGain&) const { return Method::kOutputSetGain; }
  Method operator()(const ThermalForecast&) const { return Method::kThermalForecast; }
  Method operator()(const OrientationSet&) const { return Method::kOrientationSet; }
  Method operator()(const OrientationRecenter&) const { return Method::kOrientationRecenter; }
  Method operator()(const TelemetrySubscribe&) const { return Method::kTelemetrySubscribe; }
  Method operator()(const TelemetryUnsubscribe&) const { return Method::kTelemetryUnsubscribe; }
  Method operator()(const EventsSubscribe&) const { return Method::kEventsSubscribe; }
  Method operator()(const EventsUnsubscribe&) const { return Method::kEventsUnsubscribe; }
  Method operator()(const EffectPreview&) const { return Method::kEffectPreview; }
  Method operator()(const EventsHistory&) const { return Method::kEventsHistory; }
  Method operator()(const PatternList&) const { return Method::kPatternList; }
  Method operator()(const PatternGet&) const { return Method::kPatternGet; }
  Method operator()(const PatternPut&) const { return Method::kPatternPut; }
  Method operator()(const PatternRemove&) const { return Method::kPatternRemove; }
  Method operator()(const ConnectionList&) const { return Method::kConnectionList; }
  Method operator()(const SimSet&) const { return Method::kSimSet; }
  Method operator()(const SimTruth&) const { return Method::kSimTruth; }
};

}  // namespace

Method method_of(const Request& request) noexcept { return std::visit(MethodOf{}, request); }

Request empty_request(Method method) {
  switch (method) {
    case Method::kConnectionList:
      return ConnectionList{};
    case Method::kDeviceArm:
      return DeviceArm{};
    case Method::kDeviceClaim:
      return DeviceClaim{};
    case Method::kDeviceDescribe:
      return DeviceDescribe{};
    case Method::kDeviceEmergencyStop:
      return DeviceEmergencyStop{};
    case Method::kDeviceList:
      return DeviceList{};
    case Method::kDeviceRelease:
      return DeviceRelease{};
    case Method::kDeviceStatus:
      return DeviceStatus{};
    case Method::kEffectCircle:
    case Method::kEffectHold:
    case Method::kEffectPlay:
    case Method::kEffectPulse:
    case Method::kEffectVibrate:
      return EffectStart{.method = method};
    case Method::kEffectPreview:
      return EffectPreview{};
    case Method::kEffectStop:
      return EffectStop{};
    case Method::kEffectStopAll:
      return EffectStopAll{};
    case Method::kEffectUpdate:
      return EffectUpdate{};
    case Method::kEventsHistory:
      return EventsHistory{};
    case Method::kEventsSubscribe:
      return EventsSubscribe{};
    case Method::kEventsUnsubscribe:
      return EventsUnsubscribe{};
    case Method::kHello:
      return Hello{};
    case Method::kOrientationRecenter:
      return OrientationRecenter{};
    case Method::kOrientationSet:
      return OrientationSet{};
    case Method::kOutputSetGain:
      return OutputSetGain{};
    case Method::kPatternGet:
      return PatternGet{};
    case Method::kPatternList:
      return PatternList{};
    case Method::kPatternPut:
      return PatternPut{};
    case Method::kPatternRemove:
      return PatternRemove{};
    case Method::kPing:
      return Ping{};
    case Method::kSimSet:
      return SimSet{};
    case Method::kSimTruth:
      return SimTruth{};
    case Method::kTelemetrySubscribe:
      return TelemetrySubscribe{};
    case Method::kTelemetryUnsubscribe:
      return TelemetryUnsubscribe{};
    case Method::kThermalForecast:
      return ThermalForecast{};
  }
  return Ping{};
}

}  // namespace hedgehog::protocol
