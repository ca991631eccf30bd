// SPDX-License-Identifier: MIT
// Which result answers which request, so that `Connection::call` returns the right type.
#pragma once

#include "protocol/requests.h"
#include "protocol/results.h"

namespace hedgehog::client {

template <class Request>
struct ResultOfRequest;

#define HEDGEHOG_ANSWERS(request, result)     \
  template <>                                 \
  struct ResultOfRequest<protocol::request> { \
    using Type = protocol::result;            \
  }

HEDGEHOG_ANSWERS(Hello, HelloResult);
HEDGEHOG_ANSWERS(Ping, PingResult);
HEDGEHOG_ANSWERS(EffectStart, Admission);
HEDGEHOG_ANSWERS(EffectUpdate, Admission);
HEDGEHOG_ANSWERS(EffectStop, StopResult);
HEDGEHOG_ANSWERS(EffectStopAll, StopResult);
HEDGEHOG_ANSWERS(DeviceDescribe, Description);
HEDGEHOG_ANSWERS(DeviceStatus, Status);
HEDGEHOG_ANSWERS(DeviceEmergencyStop, StateResult);
HEDGEHOG_ANSWERS(DeviceArm, StateResult);
HEDGEHOG_ANSWERS(DeviceClaim, ClaimResult);
HEDGEHOG_ANSWERS(DeviceRelease, Done);
HEDGEHOG_ANSWERS(OutputSetGain, GainResult);
HEDGEHOG_ANSWERS(ThermalForecast, ForecastResult);
HEDGEHOG_ANSWERS(OrientationSet, Done);
HEDGEHOG_ANSWERS(OrientationRecenter, RecenterResult);
HEDGEHOG_ANSWERS(TelemetrySubscribe, TelemetryResult);
HEDGEHOG_ANSWERS(TelemetryUnsubscribe, Done);
HEDGEHOG_ANSWERS(EventsSubscribe, EventsResult);
HEDGEHOG_ANSWERS(EventsUnsubscribe, Done);
HEDGEHOG_ANSWERS(EffectPreview, PreviewResult);
HEDGEHOG_ANSWERS(EventsHistory, HistoryResult);
HEDGEHOG_ANSWERS(PatternList, PatternsResult);
HEDGEHOG_ANSWERS(PatternGet, PatternResult);
HEDGEHOG_ANSWERS(PatternPut, PatternSummary);
HEDGEHOG_ANSWERS(PatternRemove, Done);
HEDGEHOG_ANSWERS(ConnectionList, ConnectionsResult);
HEDGEHOG_ANSWERS(DeviceList, DevicesResult);
HEDGEHOG_ANSWERS(SimSet, SimResult);
HEDGEHOG_ANSWERS(SimTruth, SimTruthResult);

#undef HEDGEHOG_ANSWERS

template <class Request>
using ResultOf = typename ResultOfRequest<Request>::Type;

}  // namespace hedgehog::client
