// SPDX-License-Identifier: MIT
// The fields of every value on the wire; what reading must check besides stands with them. Inside
// protocol and its tests only.
#pragma once

#include "protocol/event.h"
#include "protocol/fields.h"
#include "protocol/requests.h"
#include "protocol/results.h"

namespace hedgehog::protocol {

void describe(Fields& f, Angles& v);
void describe(Fields& f, PinNumber& v);

void describe(Fields& f, Keyframe& v);
/// The parameters of a start, or of an update when `method` is Method::kEffectUpdate.
void describe(Fields& f, EffectParams& v, Method method);

void describe(Fields& f, Hello& v);
void describe(Fields& f, EffectStart& v);
void describe(Fields& f, EffectUpdate& v);
void describe(Fields& f, EffectStop& v);
void describe(Fields& f, EffectStopAll& v);
void describe(Fields& f, EffectPreview& v);
void describe(Fields& f, DeviceClaim& v);
void describe(Fields& f, OutputSetGain& v);
void describe(Fields& f, ThermalForecast& v);
void describe(Fields& f, OrientationSet& v);
void describe(Fields& f, OrientationRecenter& v);
void describe(Fields& f, TelemetrySubscribe& v);
void describe(Fields& f, EventsSubscribe& v);
void describe(Fields& f, EventsHistory& v);
void describe(Fields& f, Pattern& v);
void describe(Fields& f, PatternGet& v);
void describe(Fields& f, PatternPut& v);
void describe(Fields& f, PatternRemove& v);
void describe(Fields& f, SimFault& v);
void describe(Fields& f, SimError& v);
void describe(Fields& f, SimSet& v);
void describe(Fields& f, SimTruth& v);
/// Methods without parameters.
template <class Empty>
requires std::is_empty_v<Empty>
void describe(Fields&, Empty&) {}

/// An object with exactly the fields of the request's method.
void describe(Fields& f, Request& v);
/// The request of `method` with nothing said yet.
Request empty_request(Method method);

void describe(Fields& f, TemperatureStatus& v);
void describe(Fields& f, FanStatus& v);
void describe(Fields& f, OrientationStatus& v);
void describe(Fields& f, EffectStatus& v);
void describe(Fields& f, LatenessStatus& v);
void describe(Fields& f, LoopStatus& v);
void describe(Fields& f, LinkStatus& v);
void describe(Fields& f, Disagreement& v);
void describe(Fields& f, TripStatus& v);
void describe(Fields& f, PinsStatus& v);
void describe(Fields& f, Status& v);
void describe(Fields& f, Telemetry& v);

void describe(Fields& f, EventDelivery& v);
void describe(Fields& f, Event& v);

void describe(Fields& f, HelloDevice& v);
void describe(Fields& f, HelloLimits& v);
void describe(Fields& f, HelloResult& v);
void describe(Fields& f, PingResult& v);
void describe(Fields& f, Admission& v);
void describe(Fields& f, StopResult& v);
void describe(Fields& f, StateResult& v);
void describe(Fields& f, ClaimResult& v);
void describe(Fields& f, GainResult& v);
void describe(Fields& f, ForecastResult& v);
void describe(Fields& f, RecenterResult& v);
void describe(Fields& f, TelemetryResult& v);
void describe(Fields& f, EventsResult& v);
void describe(Fields& f, ConnectionInfo& v);
void describe(Fields& f, ConnectionsResult& v);
void describe(Fields& f, SeenDevice& v);
void describe(Fields& f, MissingDevice& v);
void describe(Fields& f, DevicesResult& v);
void describe(Fields& f, PreviewResult& v);
void describe(Fields& f, PastEvent& v);
void describe(Fields& f, HistoryResult& v);
void describe(Fields& f, PatternSummary& v);
void describe(Fields& f, PatternsResult& v);
void describe(Fields& f, PatternResult& v);
void describe(Fields& f, SimResult& v);
void describe(Fields& f, SimTruthResult& v);

void describe(Fields& f, PinDescription& v);
void describe(Fields& f, WindingDescription& v);
void describe(Fields& f, CoilsDescription& v);
void describe(Fields& f, ThermalDescription& v);
void describe(Fields& f, UncertaintyDescription& v);
void describe(Fields& f, LimitsDescription& v);
void describe(Fields& f, CalibrationDescription& v);
void describe(Fields& f, BoardDescription& v);
void describe(Fields& f, ImuDescription& v);
void describe(Fields& f, Description& v);

}  // namespace hedgehog::protocol
