// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.

namespace Hedgehog.Results
{
    /// <summary>Done of protocol/README.md.</summary>
    public sealed class Done
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Done(Json json)
        {
            Json = json;
        }
    }

    /// <summary>Hello of protocol/README.md.</summary>
    public sealed class Hello
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Hello(Json json)
        {
            Json = json;
        }

        public string Server
        {
            get { return Json["server"].Text; }
        }

        public string Version
        {
            get { return Json["version"].Text; }
        }

        public string Protocol
        {
            get { return Json["protocol"].Text; }
        }

        public long Connection
        {
            get { return Json["connection"].Integer; }
        }

        public string StartId
        {
            get { return Json["start_id"].Text; }
        }

        public string Role
        {
            get { return Json["role"].Text; }
        }

        public string State
        {
            get { return Json["state"].Text; }
        }

        public string Reason
        {
            get { return Json["reason"].Text; }
        }

        public string Remedy
        {
            get { return Json["remedy"].Text; }
        }

        public string[] Methods
        {
            get { return Json["methods"].IsNull ? null : Read.Texts(Json["methods"]); }
        }

        public HelloDevice Device
        {
            get { return Json["device"].IsNull ? null : new HelloDevice(Json["device"]); }
        }

        public HelloLimits Limits
        {
            get { return Json["limits"].IsNull ? null : new HelloLimits(Json["limits"]); }
        }
    }

    /// <summary>HelloDevice of protocol/README.md.</summary>
    public sealed class HelloDevice
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public HelloDevice(Json json)
        {
            Json = json;
        }

        public string Name
        {
            get { return Json["name"].Text; }
        }

        public string Model
        {
            get { return Json["model"].Text; }
        }

        public bool Simulated
        {
            get { return Json["simulated"].Flag; }
        }
    }

    /// <summary>HelloLimits of protocol/README.md.</summary>
    public sealed class HelloLimits
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public HelloLimits(Json json)
        {
            Json = json;
        }

        public double CurrentA
        {
            get { return Json["current_a"].Number; }
        }

        public double ContinuousA
        {
            get { return Json["continuous_a"].Number; }
        }

        public double FeltA
        {
            get { return Json["felt_a"].Number; }
        }

        public long DurationMs
        {
            get { return Json["duration_ms"].Integer; }
        }

        public long LeaseMs
        {
            get { return Json["lease_ms"].Integer; }
        }

        public long Effects
        {
            get { return Json["effects"].Integer; }
        }

        public double FrequencyHz
        {
            get { return Json["frequency_hz"].Number; }
        }

        public double TelemetryHz
        {
            get { return Json["telemetry_hz"].Number; }
        }

        public long LineBytes
        {
            get { return Json["line_bytes"].Integer; }
        }

        public double? BurstS
        {
            get { return Json["burst_s"].IsNull ? (double?)null : Json["burst_s"].Number; }
        }
    }

    /// <summary>Ping of protocol/README.md.</summary>
    public sealed class Ping
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Ping(Json json)
        {
            Json = json;
        }

        public long TimeNs
        {
            get { return Json["time_ns"].Integer; }
        }
    }

    /// <summary>Connections of protocol/README.md.</summary>
    public sealed class Connections
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Connections(Json json)
        {
            Json = json;
        }

        public ConnectionsConnections[] ConnectionsValue
        {
            get { return Json["connections"].IsNull ? null : Read.List(Json["connections"], one => new ConnectionsConnections(one)); }
        }
    }

    /// <summary>ConnectionsConnections of protocol/README.md.</summary>
    public sealed class ConnectionsConnections
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public ConnectionsConnections(Json json)
        {
            Json = json;
        }

        public long Connection
        {
            get { return Json["connection"].Integer; }
        }

        public string Client
        {
            get { return Json["client"].Text; }
        }

        public string Transport
        {
            get { return Json["transport"].Text; }
        }

        public string Address
        {
            get { return Json["address"].Text; }
        }

        public long? Uid
        {
            get { return Json["uid"].IsNull ? (long?)null : Json["uid"].Integer; }
        }

        public long? Pid
        {
            get { return Json["pid"].IsNull ? (long?)null : Json["pid"].Integer; }
        }

        public string Role
        {
            get { return Json["role"].Text; }
        }

        public double SinceS
        {
            get { return Json["since_s"].Number; }
        }

        public bool Claimed
        {
            get { return Json["claimed"].Flag; }
        }

        public ConnectionsConnectionsEffects[] Effects
        {
            get { return Json["effects"].IsNull ? null : Read.List(Json["effects"], one => new ConnectionsConnectionsEffects(one)); }
        }
    }

    /// <summary>ConnectionsConnectionsEffects of protocol/README.md.</summary>
    public sealed class ConnectionsConnectionsEffects
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public ConnectionsConnectionsEffects(Json json)
        {
            Json = json;
        }

        public long Effect
        {
            get { return Json["effect"].Integer; }
        }

        public string Slot
        {
            get { return Json["slot"].Text; }
        }

        public string Method
        {
            get { return Json["method"].Text; }
        }

        public long Connection
        {
            get { return Json["connection"].Integer; }
        }

        public string Client
        {
            get { return Json["client"].Text; }
        }

        public long Priority
        {
            get { return Json["priority"].Integer; }
        }

        public bool Playing
        {
            get { return Json["playing"].Flag; }
        }

        public long RemainingMs
        {
            get { return Json["remaining_ms"].Integer; }
        }

        public double CurrentA
        {
            get { return Json["current_a"].Number; }
        }
    }

    /// <summary>State of protocol/README.md.</summary>
    public sealed class State
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public State(Json json)
        {
            Json = json;
        }

        public string StateValue
        {
            get { return Json["state"].Text; }
        }

        public string Reason
        {
            get { return Json["reason"].Text; }
        }

        public string Remedy
        {
            get { return Json["remedy"].Text; }
        }

        public long Seq
        {
            get { return Json["seq"].Integer; }
        }

        public bool? OnDisk
        {
            get { return Json["on_disk"].IsNull ? (bool?)null : Json["on_disk"].Flag; }
        }
    }

    /// <summary>Claim of protocol/README.md.</summary>
    public sealed class Claim
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Claim(Json json)
        {
            Json = json;
        }

        public long LeaseMs
        {
            get { return Json["lease_ms"].Integer; }
        }
    }

    /// <summary>Description of protocol/README.md.</summary>
    public sealed class Description
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Description(Json json)
        {
            Json = json;
        }

        public string Name
        {
            get { return Json["name"].Text; }
        }

        public string Model
        {
            get { return Json["model"].Text; }
        }

        public bool Simulated
        {
            get { return Json["simulated"].Flag; }
        }

        public string Arrangement
        {
            get { return Json["arrangement"].Text; }
        }

        public DescriptionPins[] Pins
        {
            get { return Json["pins"].IsNull ? null : Read.List(Json["pins"], one => new DescriptionPins(one)); }
        }

        public DescriptionCoils Coils
        {
            get { return Json["coils"].IsNull ? null : new DescriptionCoils(Json["coils"]); }
        }

        public DescriptionThermal Thermal
        {
            get { return Json["thermal"].IsNull ? null : new DescriptionThermal(Json["thermal"]); }
        }

        public DescriptionUncertainty Uncertainty
        {
            get { return Json["uncertainty"].IsNull ? null : new DescriptionUncertainty(Json["uncertainty"]); }
        }

        public DescriptionLimits Limits
        {
            get { return Json["limits"].IsNull ? null : new DescriptionLimits(Json["limits"]); }
        }

        public DescriptionCalibration Calibration
        {
            get { return Json["calibration"].IsNull ? null : new DescriptionCalibration(Json["calibration"]); }
        }

        public double Gain
        {
            get { return Json["gain"].Number; }
        }

        public DescriptionBoard Board
        {
            get { return Json["board"].IsNull ? null : new DescriptionBoard(Json["board"]); }
        }

        public DescriptionImu Imu
        {
            get { return Json["imu"].IsNull ? null : new DescriptionImu(Json["imu"]); }
        }
    }

    /// <summary>DescriptionPins of protocol/README.md.</summary>
    public sealed class DescriptionPins
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DescriptionPins(Json json)
        {
            Json = json;
        }

        public long Pin
        {
            get { return Json["pin"].Integer; }
        }

        public double[] Position
        {
            get { return Json["position"].IsNull ? null : Read.Numbers(Json["position"]); }
        }

        public long Ring
        {
            get { return Json["ring"].Integer; }
        }

        public double RestMm
        {
            get { return Json["rest_mm"].Number; }
        }
    }

    /// <summary>DescriptionCoils of protocol/README.md.</summary>
    public sealed class DescriptionCoils
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DescriptionCoils(Json json)
        {
            Json = json;
        }

        public Json Matrix
        {
            get { return Json["matrix"]; }
        }

        public double[] R25Ohm
        {
            get { return Json["r25_ohm"].IsNull ? null : Read.Numbers(Json["r25_ohm"]); }
        }

        public double InductanceH
        {
            get { return Json["inductance_h"].Number; }
        }

        public double SupplyV
        {
            get { return Json["supply_v"].Number; }
        }

        public DescriptionCoilsMeasured[] Measured
        {
            get { return Json["measured"].IsNull ? null : Read.List(Json["measured"], one => new DescriptionCoilsMeasured(one)); }
        }
    }

    /// <summary>DescriptionCoilsMeasured of protocol/README.md.</summary>
    public sealed class DescriptionCoilsMeasured
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DescriptionCoilsMeasured(Json json)
        {
            Json = json;
        }

        public double? R25Ohm
        {
            get { return Json["r25_ohm"].IsNull ? (double?)null : Json["r25_ohm"].Number; }
        }

        public double? FromFile
        {
            get { return Json["from_file"].IsNull ? (double?)null : Json["from_file"].Number; }
        }

        public double? FromKept
        {
            get { return Json["from_kept"].IsNull ? (double?)null : Json["from_kept"].Number; }
        }
    }

    /// <summary>DescriptionThermal of protocol/README.md.</summary>
    public sealed class DescriptionThermal
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DescriptionThermal(Json json)
        {
            Json = json;
        }

        public double[] WindingJK
        {
            get { return Json["winding_j_k"].IsNull ? null : Read.Numbers(Json["winding_j_k"]); }
        }

        public double CoreJK
        {
            get { return Json["core_j_k"].Number; }
        }

        public double[] WindingToCoreKW
        {
            get { return Json["winding_to_core_k_w"].IsNull ? null : Read.Numbers(Json["winding_to_core_k_w"]); }
        }

        public double CoreToRoomFanKW
        {
            get { return Json["core_to_room_fan_k_w"].Number; }
        }

        public double CoreToRoomStillKW
        {
            get { return Json["core_to_room_still_k_w"].Number; }
        }

        public long SensorWinding
        {
            get { return Json["sensor_winding"].Integer; }
        }

        public double SensorLagS
        {
            get { return Json["sensor_lag_s"].Number; }
        }
    }

    /// <summary>DescriptionUncertainty of protocol/README.md.</summary>
    public sealed class DescriptionUncertainty
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DescriptionUncertainty(Json json)
        {
            Json = json;
        }

        public double Thermal
        {
            get { return Json["thermal"].Number; }
        }

        public double Resistance
        {
            get { return Json["resistance"].Number; }
        }

        public double ThermistorK
        {
            get { return Json["thermistor_k"].Number; }
        }
    }

    /// <summary>DescriptionLimits of protocol/README.md.</summary>
    public sealed class DescriptionLimits
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DescriptionLimits(Json json)
        {
            Json = json;
        }

        public double CurrentA
        {
            get { return Json["current_a"].Number; }
        }

        public double ContinuousA
        {
            get { return Json["continuous_a"].Number; }
        }

        public double FeltA
        {
            get { return Json["felt_a"].Number; }
        }

        public double DerateFromC
        {
            get { return Json["derate_from_c"].Number; }
        }

        public double SustainC
        {
            get { return Json["sustain_c"].Number; }
        }

        public double ZeroC
        {
            get { return Json["zero_c"].Number; }
        }

        public double TripC
        {
            get { return Json["trip_c"].Number; }
        }

        public double RearmC
        {
            get { return Json["rearm_c"].Number; }
        }
    }

    /// <summary>DescriptionCalibration of protocol/README.md.</summary>
    public sealed class DescriptionCalibration
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DescriptionCalibration(Json json)
        {
            Json = json;
        }

        public double ForceNPerA
        {
            get { return Json["force_n_per_a"].Number; }
        }
    }

    /// <summary>DescriptionBoard of protocol/README.md.</summary>
    public sealed class DescriptionBoard
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DescriptionBoard(Json json)
        {
            Json = json;
        }

        public string Backend
        {
            get { return Json["backend"].Text; }
        }

        public bool Present
        {
            get { return Json["present"].Flag; }
        }

        public string Serial
        {
            get { return Json["serial"].Text; }
        }

        public string Firmware
        {
            get { return Json["firmware"].Text; }
        }

        public string Protocol
        {
            get { return Json["protocol"].Text; }
        }
    }

    /// <summary>DescriptionImu of protocol/README.md.</summary>
    public sealed class DescriptionImu
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DescriptionImu(Json json)
        {
            Json = json;
        }

        public string Type
        {
            get { return Json["type"].Text; }
        }

        public bool Present
        {
            get { return Json["present"].Flag; }
        }
    }

    /// <summary>Status of protocol/README.md.</summary>
    public sealed class Status
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Status(Json json)
        {
            Json = json;
        }

        public string Device
        {
            get { return Json["device"].Text; }
        }

        public bool Simulated
        {
            get { return Json["simulated"].Flag; }
        }

        public long TimeNs
        {
            get { return Json["time_ns"].Integer; }
        }

        public string State
        {
            get { return Json["state"].Text; }
        }

        public string Reason
        {
            get { return Json["reason"].Text; }
        }

        public double SinceS
        {
            get { return Json["since_s"].Number; }
        }

        public string Remedy
        {
            get { return Json["remedy"].Text; }
        }

        public StatusTemperatureC TemperatureC
        {
            get { return Json["temperature_c"].IsNull ? null : new StatusTemperatureC(Json["temperature_c"]); }
        }

        public double LimitA
        {
            get { return Json["limit_a"].Number; }
        }

        public double? HeadroomS
        {
            get { return Json["headroom_s"].IsNull ? (double?)null : Json["headroom_s"].Number; }
        }

        public double? BurstS
        {
            get { return Json["burst_s"].IsNull ? (double?)null : Json["burst_s"].Number; }
        }

        public bool Derating
        {
            get { return Json["derating"].Flag; }
        }

        public double[] CurrentA
        {
            get { return Json["current_a"].IsNull ? null : Read.Numbers(Json["current_a"]); }
        }

        public double[] Duty
        {
            get { return Json["duty"].IsNull ? null : Read.Numbers(Json["duty"]); }
        }

        public double? SupplyV
        {
            get { return Json["supply_v"].IsNull ? (double?)null : Json["supply_v"].Number; }
        }

        public double[] Field
        {
            get { return Json["field"].IsNull ? null : Read.Numbers(Json["field"]); }
        }

        public double ForceN
        {
            get { return Json["force_n"].Number; }
        }

        public long? Pin
        {
            get { return Json["pin"].IsNull ? (long?)null : Json["pin"].Integer; }
        }

        public StatusFan Fan
        {
            get { return Json["fan"].IsNull ? null : new StatusFan(Json["fan"]); }
        }

        public StatusOrientation Orientation
        {
            get { return Json["orientation"].IsNull ? null : new StatusOrientation(Json["orientation"]); }
        }

        public ConnectionsConnectionsEffects[] Effects
        {
            get { return Json["effects"].IsNull ? null : Read.List(Json["effects"], one => new ConnectionsConnectionsEffects(one)); }
        }

        public StatusLoop Loop
        {
            get { return Json["loop"].IsNull ? null : new StatusLoop(Json["loop"]); }
        }

        public StatusLink Link
        {
            get { return Json["link"].IsNull ? null : new StatusLink(Json["link"]); }
        }

        public long AppliedSeq
        {
            get { return Json["applied_seq"].Integer; }
        }

        public StatusLastTrip LastTrip
        {
            get { return Json["last_trip"].IsNull ? null : new StatusLastTrip(Json["last_trip"]); }
        }

        public StatusPins Pins
        {
            get { return Json["pins"].IsNull ? null : new StatusPins(Json["pins"]); }
        }
    }

    /// <summary>StatusTemperatureC of protocol/README.md.</summary>
    public sealed class StatusTemperatureC
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public StatusTemperatureC(Json json)
        {
            Json = json;
        }

        public double? Sensor
        {
            get { return Json["sensor"].IsNull ? (double?)null : Json["sensor"].Number; }
        }

        public double? Model
        {
            get { return Json["model"].IsNull ? (double?)null : Json["model"].Number; }
        }

        public double[] Coils
        {
            get { return Json["coils"].IsNull ? null : Read.Numbers(Json["coils"]); }
        }

        public double? Upper
        {
            get { return Json["upper"].IsNull ? (double?)null : Json["upper"].Number; }
        }

        public double? Core
        {
            get { return Json["core"].IsNull ? (double?)null : Json["core"].Number; }
        }

        public double[] Sensors
        {
            get { return Json["sensors"].IsNull ? null : Read.Numbers(Json["sensors"]); }
        }

        public double? Skin
        {
            get { return Json["skin"].IsNull ? (double?)null : Json["skin"].Number; }
        }

        public long? AgeMs
        {
            get { return Json["age_ms"].IsNull ? (long?)null : Json["age_ms"].Integer; }
        }

        public double? Thermometer
        {
            get { return Json["thermometer"].IsNull ? (double?)null : Json["thermometer"].Number; }
        }
    }

    /// <summary>StatusFan of protocol/README.md.</summary>
    public sealed class StatusFan
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public StatusFan(Json json)
        {
            Json = json;
        }

        public double? SpeedRpm
        {
            get { return Json["speed_rpm"].IsNull ? (double?)null : Json["speed_rpm"].Number; }
        }

        public double Duty
        {
            get { return Json["duty"].Number; }
        }

        public bool? Cooling
        {
            get { return Json["cooling"].IsNull ? (bool?)null : Json["cooling"].Flag; }
        }
    }

    /// <summary>StatusOrientation of protocol/README.md.</summary>
    public sealed class StatusOrientation
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public StatusOrientation(Json json)
        {
            Json = json;
        }

        public StatusOrientationQuaternion Quaternion
        {
            get { return Json["quaternion"].IsNull ? null : new StatusOrientationQuaternion(Json["quaternion"]); }
        }

        public double[] Up
        {
            get { return Json["up"].IsNull ? null : Read.Numbers(Json["up"]); }
        }

        public double[] RateDegS
        {
            get { return Json["rate_deg_s"].IsNull ? null : Read.Numbers(Json["rate_deg_s"]); }
        }

        public long AgeMs
        {
            get { return Json["age_ms"].Integer; }
        }
    }

    /// <summary>StatusOrientationQuaternion of protocol/README.md.</summary>
    public sealed class StatusOrientationQuaternion
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public StatusOrientationQuaternion(Json json)
        {
            Json = json;
        }

        public double W
        {
            get { return Json["w"].Number; }
        }

        public double X
        {
            get { return Json["x"].Number; }
        }

        public double Y
        {
            get { return Json["y"].Number; }
        }

        public double Z
        {
            get { return Json["z"].Number; }
        }
    }

    /// <summary>StatusLoop of protocol/README.md.</summary>
    public sealed class StatusLoop
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public StatusLoop(Json json)
        {
            Json = json;
        }

        public double RateHz
        {
            get { return Json["rate_hz"].Number; }
        }

        public long Ticks
        {
            get { return Json["ticks"].Integer; }
        }

        public long Skipped
        {
            get { return Json["skipped"].Integer; }
        }

        public StatusLoopLatenessUs LatenessUs
        {
            get { return Json["lateness_us"].IsNull ? null : new StatusLoopLatenessUs(Json["lateness_us"]); }
        }
    }

    /// <summary>StatusLoopLatenessUs of protocol/README.md.</summary>
    public sealed class StatusLoopLatenessUs
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public StatusLoopLatenessUs(Json json)
        {
            Json = json;
        }

        public double P50
        {
            get { return Json["p50"].Number; }
        }

        public double P99
        {
            get { return Json["p99"].Number; }
        }

        public double Max
        {
            get { return Json["max"].Number; }
        }
    }

    /// <summary>StatusLink of protocol/README.md.</summary>
    public sealed class StatusLink
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public StatusLink(Json json)
        {
            Json = json;
        }

        public long FramesOut
        {
            get { return Json["frames_out"].Integer; }
        }

        public long Lost
        {
            get { return Json["lost"].Integer; }
        }

        public long Errors
        {
            get { return Json["errors"].Integer; }
        }
    }

    /// <summary>StatusLastTrip of protocol/README.md.</summary>
    public sealed class StatusLastTrip
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public StatusLastTrip(Json json)
        {
            Json = json;
        }

        public string Reason
        {
            get { return Json["reason"].Text; }
        }

        public long TimeNs
        {
            get { return Json["time_ns"].Integer; }
        }

        public double? TemperatureC
        {
            get { return Json["temperature_c"].IsNull ? (double?)null : Json["temperature_c"].Number; }
        }

        public double CurrentA
        {
            get { return Json["current_a"].Number; }
        }

        public StatusLastTripDisagreement Disagreement
        {
            get { return Json["disagreement"].IsNull ? null : new StatusLastTripDisagreement(Json["disagreement"]); }
        }
    }

    /// <summary>StatusLastTripDisagreement of protocol/README.md.</summary>
    public sealed class StatusLastTripDisagreement
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public StatusLastTripDisagreement(Json json)
        {
            Json = json;
        }

        public long Coil
        {
            get { return Json["coil"].Integer; }
        }

        public string[] Between
        {
            get { return Json["between"].IsNull ? null : Read.Texts(Json["between"]); }
        }
    }

    /// <summary>StatusPins of protocol/README.md.</summary>
    public sealed class StatusPins
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public StatusPins(Json json)
        {
            Json = json;
        }

        public double[] ForceN
        {
            get { return Json["force_n"].IsNull ? null : Read.Numbers(Json["force_n"]); }
        }

        public double[] ExtensionMm
        {
            get { return Json["extension_mm"].IsNull ? null : Read.Numbers(Json["extension_mm"]); }
        }
    }

    /// <summary>Devices of protocol/README.md.</summary>
    public sealed class Devices
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Devices(Json json)
        {
            Json = json;
        }

        public DevicesDevices[] DevicesValue
        {
            get { return Json["devices"].IsNull ? null : Read.List(Json["devices"], one => new DevicesDevices(one)); }
        }

        public DevicesMissing[] Missing
        {
            get { return Json["missing"].IsNull ? null : Read.List(Json["missing"], one => new DevicesMissing(one)); }
        }

        public long Others
        {
            get { return Json["others"].Integer; }
        }
    }

    /// <summary>DevicesDevices of protocol/README.md.</summary>
    public sealed class DevicesDevices
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DevicesDevices(Json json)
        {
            Json = json;
        }

        public string Path
        {
            get { return Json["path"].Text; }
        }

        public string Ids
        {
            get { return Json["ids"].Text; }
        }

        public string Name
        {
            get { return Json["name"].Text; }
        }

        public string Serial
        {
            get { return Json["serial"].Text; }
        }

        public string Firmware
        {
            get { return Json["firmware"].Text; }
        }

        public string Protocol
        {
            get { return Json["protocol"].Text; }
        }

        public string Use
        {
            get { return Json["use"].Text; }
        }

        public string WhyNot
        {
            get { return Json["why_not"].Text; }
        }
    }

    /// <summary>DevicesMissing of protocol/README.md.</summary>
    public sealed class DevicesMissing
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public DevicesMissing(Json json)
        {
            Json = json;
        }

        public string Use
        {
            get { return Json["use"].Text; }
        }

        public string Why
        {
            get { return Json["why"].Text; }
        }
    }

    /// <summary>Admission of protocol/README.md.</summary>
    public sealed class Admission
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Admission(Json json)
        {
            Json = json;
        }

        public long Effect
        {
            get { return Json["effect"].Integer; }
        }

        public string Slot
        {
            get { return Json["slot"].Text; }
        }

        public bool Accepted
        {
            get { return Json["accepted"].Flag; }
        }

        public string LimitedBy
        {
            get { return Json["limited_by"].Text; }
        }

        public double CurrentA
        {
            get { return Json["current_a"].Number; }
        }

        public double ForceN
        {
            get { return Json["force_n"].Number; }
        }

        public long Pin
        {
            get { return Json["pin"].Integer; }
        }

        public double? HeadroomS
        {
            get { return Json["headroom_s"].IsNull ? (double?)null : Json["headroom_s"].Number; }
        }

        public long Seq
        {
            get { return Json["seq"].Integer; }
        }

        public double? PeriodMs
        {
            get { return Json["period_ms"].IsNull ? (double?)null : Json["period_ms"].Number; }
        }
    }

    /// <summary>Stopped of protocol/README.md.</summary>
    public sealed class Stopped
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Stopped(Json json)
        {
            Json = json;
        }

        public long StoppedValue
        {
            get { return Json["stopped"].Integer; }
        }

        public long Seq
        {
            get { return Json["seq"].Integer; }
        }
    }

    /// <summary>Preview of protocol/README.md.</summary>
    public sealed class Preview
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Preview(Json json)
        {
            Json = json;
        }

        public long DurationMs
        {
            get { return Json["duration_ms"].Integer; }
        }

        public long StepMs
        {
            get { return Json["step_ms"].Integer; }
        }

        public Json Duty
        {
            get { return Json["duty"]; }
        }

        public Json CurrentA
        {
            get { return Json["current_a"]; }
        }

        public double PeakCurrentA
        {
            get { return Json["peak_current_a"].Number; }
        }

        public double TemperatureC
        {
            get { return Json["temperature_c"].Number; }
        }

        public double PeakTemperatureC
        {
            get { return Json["peak_temperature_c"].Number; }
        }

        public string LimitedBy
        {
            get { return Json["limited_by"].Text; }
        }

        public long? LimitedFromMs
        {
            get { return Json["limited_from_ms"].IsNull ? (long?)null : Json["limited_from_ms"].Integer; }
        }

        public PreviewDelivered Delivered
        {
            get { return Json["delivered"].IsNull ? null : new PreviewDelivered(Json["delivered"]); }
        }
    }

    /// <summary>PreviewDelivered of protocol/README.md.</summary>
    public sealed class PreviewDelivered
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public PreviewDelivered(Json json)
        {
            Json = json;
        }

        public double Min
        {
            get { return Json["min"].Number; }
        }

        public double Mean
        {
            get { return Json["mean"].Number; }
        }
    }

    /// <summary>Latency of protocol/README.md.</summary>
    public sealed class Latency
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Latency(Json json)
        {
            Json = json;
        }

        public long Effects
        {
            get { return Json["effects"].Integer; }
        }

        public StatusLoopLatenessUs ReceivedToQueuedUs
        {
            get { return Json["received_to_queued_us"].IsNull ? null : new StatusLoopLatenessUs(Json["received_to_queued_us"]); }
        }

        public StatusLoopLatenessUs QueuedToAppliedUs
        {
            get { return Json["queued_to_applied_us"].IsNull ? null : new StatusLoopLatenessUs(Json["queued_to_applied_us"]); }
        }

        public StatusLoopLatenessUs AppliedToWrittenUs
        {
            get { return Json["applied_to_written_us"].IsNull ? null : new StatusLoopLatenessUs(Json["applied_to_written_us"]); }
        }

        public StatusLoopLatenessUs ReceivedToWrittenUs
        {
            get { return Json["received_to_written_us"].IsNull ? null : new StatusLoopLatenessUs(Json["received_to_written_us"]); }
        }
    }

    /// <summary>EventsSubscription of protocol/README.md.</summary>
    public sealed class EventsSubscription
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public EventsSubscription(Json json)
        {
            Json = json;
        }

        public string State
        {
            get { return Json["state"].Text; }
        }

        public string Reason
        {
            get { return Json["reason"].Text; }
        }

        public bool Derating
        {
            get { return Json["derating"].Flag; }
        }

        public double LimitA
        {
            get { return Json["limit_a"].Number; }
        }
    }

    /// <summary>History of protocol/README.md.</summary>
    public sealed class History
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public History(Json json)
        {
            Json = json;
        }

        public HistoryEvents[] Events
        {
            get { return Json["events"].IsNull ? null : Read.List(Json["events"], one => new HistoryEvents(one)); }
        }

        public bool More
        {
            get { return Json["more"].Flag; }
        }
    }

    /// <summary>HistoryEvents of protocol/README.md.</summary>
    public sealed class HistoryEvents
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public HistoryEvents(Json json)
        {
            Json = json;
        }

        public string At
        {
            get { return Json["at"].Text; }
        }

        public string Type
        {
            get { return Json["type"].Text; }
        }

        public long TimeNs
        {
            get { return Json["time_ns"].Integer; }
        }

        public string State
        {
            get { return Json["state"].Text; }
        }

        public long? Effect
        {
            get { return Json["effect"].IsNull ? (long?)null : Json["effect"].Integer; }
        }

        public string Slot
        {
            get { return Json["slot"].Text; }
        }

        public long? Seq
        {
            get { return Json["seq"].IsNull ? (long?)null : Json["seq"].Integer; }
        }

        public string Reason
        {
            get { return Json["reason"].Text; }
        }

        public string Remedy
        {
            get { return Json["remedy"].Text; }
        }

        public long? OnsetNs
        {
            get { return Json["onset_ns"].IsNull ? (long?)null : Json["onset_ns"].Integer; }
        }

        public long? OffsetNs
        {
            get { return Json["offset_ns"].IsNull ? (long?)null : Json["offset_ns"].Integer; }
        }

        public PreviewDelivered Delivered
        {
            get { return Json["delivered"].IsNull ? null : new PreviewDelivered(Json["delivered"]); }
        }

        public long? MaskedMs
        {
            get { return Json["masked_ms"].IsNull ? (long?)null : Json["masked_ms"].Integer; }
        }

        public long? MixedMs
        {
            get { return Json["mixed_ms"].IsNull ? (long?)null : Json["mixed_ms"].Integer; }
        }

        public double? LimitA
        {
            get { return Json["limit_a"].IsNull ? (double?)null : Json["limit_a"].Number; }
        }

        public double? TemperatureC
        {
            get { return Json["temperature_c"].IsNull ? (double?)null : Json["temperature_c"].Number; }
        }

        public double? CurrentA
        {
            get { return Json["current_a"].IsNull ? (double?)null : Json["current_a"].Number; }
        }

        public StatusLastTripDisagreement Disagreement
        {
            get { return Json["disagreement"].IsNull ? null : new StatusLastTripDisagreement(Json["disagreement"]); }
        }

        public string Device
        {
            get { return Json["device"].Text; }
        }

        public long? Skipped
        {
            get { return Json["skipped"].IsNull ? (long?)null : Json["skipped"].Integer; }
        }

        public string Method
        {
            get { return Json["method"].Text; }
        }

        public string Client
        {
            get { return Json["client"].Text; }
        }

        public string Recording
        {
            get { return Json["recording"].Text; }
        }

        public long? Count
        {
            get { return Json["count"].IsNull ? (long?)null : Json["count"].Integer; }
        }

        public string Last
        {
            get { return Json["last"].Text; }
        }
    }

    /// <summary>Recentered of protocol/README.md.</summary>
    public sealed class Recentered
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Recentered(Json json)
        {
            Json = json;
        }

        public double YawOffsetDeg
        {
            get { return Json["yaw_offset_deg"].Number; }
        }
    }

    /// <summary>Gain of protocol/README.md.</summary>
    public sealed class Gain
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Gain(Json json)
        {
            Json = json;
        }

        public double GainValue
        {
            get { return Json["gain"].Number; }
        }

        public long Seq
        {
            get { return Json["seq"].Integer; }
        }
    }

    /// <summary>Patterns of protocol/README.md.</summary>
    public sealed class Patterns
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Patterns(Json json)
        {
            Json = json;
        }

        public PatternsPatterns[] PatternsValue
        {
            get { return Json["patterns"].IsNull ? null : Read.List(Json["patterns"], one => new PatternsPatterns(one)); }
        }
    }

    /// <summary>PatternsPatterns of protocol/README.md.</summary>
    public sealed class PatternsPatterns
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public PatternsPatterns(Json json)
        {
            Json = json;
        }

        public string Name
        {
            get { return Json["name"].Text; }
        }

        public string Description
        {
            get { return Json["description"].Text; }
        }

        public long DurationMs
        {
            get { return Json["duration_ms"].Integer; }
        }

        public long Keyframes
        {
            get { return Json["keyframes"].Integer; }
        }

        public bool Shipped
        {
            get { return Json["shipped"].Flag; }
        }
    }

    /// <summary>Pattern of protocol/README.md.</summary>
    public sealed class Pattern
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Pattern(Json json)
        {
            Json = json;
        }

        public string Name
        {
            get { return Json["name"].Text; }
        }

        public string Description
        {
            get { return Json["description"].Text; }
        }

        public string Waveform
        {
            get { return Json["waveform"].Text; }
        }

        public double? FrequencyHz
        {
            get { return Json["frequency_hz"].IsNull ? (double?)null : Json["frequency_hz"].Number; }
        }

        public double? OnFraction
        {
            get { return Json["on_fraction"].IsNull ? (double?)null : Json["on_fraction"].Number; }
        }

        public PatternKeyframes[] Keyframes
        {
            get { return Json["keyframes"].IsNull ? null : Read.List(Json["keyframes"], one => new PatternKeyframes(one)); }
        }

        public long DurationMs
        {
            get { return Json["duration_ms"].Integer; }
        }

        public bool Shipped
        {
            get { return Json["shipped"].Flag; }
        }
    }

    /// <summary>PatternKeyframes of protocol/README.md.</summary>
    public sealed class PatternKeyframes
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public PatternKeyframes(Json json)
        {
            Json = json;
        }

        public double TMs
        {
            get { return Json["t_ms"].Number; }
        }

        public Json Direction
        {
            get { return Json["direction"]; }
        }

        public double Level
        {
            get { return Json["level"].Number; }
        }

        public string Ease
        {
            get { return Json["ease"].Text; }
        }
    }

    /// <summary>PatternSummary of protocol/README.md.</summary>
    public sealed class PatternSummary
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public PatternSummary(Json json)
        {
            Json = json;
        }

        public string Name
        {
            get { return Json["name"].Text; }
        }

        public string Description
        {
            get { return Json["description"].Text; }
        }

        public long DurationMs
        {
            get { return Json["duration_ms"].Integer; }
        }

        public long Keyframes
        {
            get { return Json["keyframes"].Integer; }
        }

        public bool Shipped
        {
            get { return Json["shipped"].Flag; }
        }
    }

    /// <summary>SimulatedWorld of protocol/README.md.</summary>
    public sealed class SimulatedWorld
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public SimulatedWorld(Json json)
        {
            Json = json;
        }

        public double AmbientC
        {
            get { return Json["ambient_c"].Number; }
        }

        public string[] Faults
        {
            get { return Json["faults"].IsNull ? null : Read.Texts(Json["faults"]); }
        }

        public long Coil
        {
            get { return Json["coil"].Integer; }
        }

        public SimulatedWorldErrors[] Errors
        {
            get { return Json["errors"].IsNull ? null : Read.List(Json["errors"], one => new SimulatedWorldErrors(one)); }
        }
    }

    /// <summary>SimulatedWorldErrors of protocol/README.md.</summary>
    public sealed class SimulatedWorldErrors
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public SimulatedWorldErrors(Json json)
        {
            Json = json;
        }

        public string Kind
        {
            get { return Json["kind"].Text; }
        }

        public long? Coil
        {
            get { return Json["coil"].IsNull ? (long?)null : Json["coil"].Integer; }
        }

        public double Value
        {
            get { return Json["value"].Number; }
        }

        public double? RampS
        {
            get { return Json["ramp_s"].IsNull ? (double?)null : Json["ramp_s"].Number; }
        }
    }

    /// <summary>SimulatedTruth of protocol/README.md.</summary>
    public sealed class SimulatedTruth
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public SimulatedTruth(Json json)
        {
            Json = json;
        }

        public double[] CoilsC
        {
            get { return Json["coils_c"].IsNull ? null : Read.Numbers(Json["coils_c"]); }
        }

        public double CoreC
        {
            get { return Json["core_c"].Number; }
        }

        public double SkinC
        {
            get { return Json["skin_c"].Number; }
        }

        public double[] CurrentA
        {
            get { return Json["current_a"].IsNull ? null : Read.Numbers(Json["current_a"]); }
        }

        public double AmbientC
        {
            get { return Json["ambient_c"].Number; }
        }
    }

    /// <summary>TelemetrySubscription of protocol/README.md.</summary>
    public sealed class TelemetrySubscription
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public TelemetrySubscription(Json json)
        {
            Json = json;
        }

        public double RateHz
        {
            get { return Json["rate_hz"].Number; }
        }

        public string[] Fields
        {
            get { return Json["fields"].IsNull ? null : Read.Texts(Json["fields"]); }
        }
    }

    /// <summary>TelemetryHistory of protocol/README.md.</summary>
    public sealed class TelemetryHistory
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public TelemetryHistory(Json json)
        {
            Json = json;
        }

        public long TimeNs
        {
            get { return Json["time_ns"].Integer; }
        }

        public double StepS
        {
            get { return Json["step_s"].Number; }
        }

        public TelemetryHistorySamples[] Samples
        {
            get { return Json["samples"].IsNull ? null : Read.List(Json["samples"], one => new TelemetryHistorySamples(one)); }
        }
    }

    /// <summary>TelemetryHistorySamples of protocol/README.md.</summary>
    public sealed class TelemetryHistorySamples
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public TelemetryHistorySamples(Json json)
        {
            Json = json;
        }

        public double AgeS
        {
            get { return Json["age_s"].Number; }
        }

        public double[] CoilsC
        {
            get { return Json["coils_c"].IsNull ? null : Read.Numbers(Json["coils_c"]); }
        }

        public double? UpperC
        {
            get { return Json["upper_c"].IsNull ? (double?)null : Json["upper_c"].Number; }
        }

        public double? SensorC
        {
            get { return Json["sensor_c"].IsNull ? (double?)null : Json["sensor_c"].Number; }
        }

        public double CurrentA
        {
            get { return Json["current_a"].Number; }
        }

        public double PeakA
        {
            get { return Json["peak_a"].Number; }
        }

        public double LimitA
        {
            get { return Json["limit_a"].Number; }
        }

        public double[] Duty
        {
            get { return Json["duty"].IsNull ? null : Read.Numbers(Json["duty"]); }
        }

        public double? HeadroomS
        {
            get { return Json["headroom_s"].IsNull ? (double?)null : Json["headroom_s"].Number; }
        }
    }

    /// <summary>Forecast of protocol/README.md.</summary>
    public sealed class Forecast
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Forecast(Json json)
        {
            Json = json;
        }

        public double? SecondsToDerating
        {
            get { return Json["seconds_to_derating"].IsNull ? (double?)null : Json["seconds_to_derating"].Number; }
        }

        public double? SecondsToLimit
        {
            get { return Json["seconds_to_limit"].IsNull ? (double?)null : Json["seconds_to_limit"].Number; }
        }

        public double SustainableA
        {
            get { return Json["sustainable_a"].Number; }
        }

        public double? RecoveryS
        {
            get { return Json["recovery_s"].IsNull ? (double?)null : Json["recovery_s"].Number; }
        }

        public bool TemperatureKnown
        {
            get { return Json["temperature_known"].Flag; }
        }
    }

    /// <summary>Telemetry of protocol/README.md.</summary>
    public sealed class Telemetry
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Telemetry(Json json)
        {
            Json = json;
        }

        public string Device
        {
            get { return Json["device"].Text; }
        }

        public bool? Simulated
        {
            get { return Json["simulated"].IsNull ? (bool?)null : Json["simulated"].Flag; }
        }

        public long TimeNs
        {
            get { return Json["time_ns"].Integer; }
        }

        public string State
        {
            get { return Json["state"].Text; }
        }

        public string Reason
        {
            get { return Json["reason"].Text; }
        }

        public double? SinceS
        {
            get { return Json["since_s"].IsNull ? (double?)null : Json["since_s"].Number; }
        }

        public string Remedy
        {
            get { return Json["remedy"].Text; }
        }

        public StatusTemperatureC TemperatureC
        {
            get { return Json["temperature_c"].IsNull ? null : new StatusTemperatureC(Json["temperature_c"]); }
        }

        public double? LimitA
        {
            get { return Json["limit_a"].IsNull ? (double?)null : Json["limit_a"].Number; }
        }

        public double? HeadroomS
        {
            get { return Json["headroom_s"].IsNull ? (double?)null : Json["headroom_s"].Number; }
        }

        public double? BurstS
        {
            get { return Json["burst_s"].IsNull ? (double?)null : Json["burst_s"].Number; }
        }

        public bool? Derating
        {
            get { return Json["derating"].IsNull ? (bool?)null : Json["derating"].Flag; }
        }

        public double[] CurrentA
        {
            get { return Json["current_a"].IsNull ? null : Read.Numbers(Json["current_a"]); }
        }

        public double[] Duty
        {
            get { return Json["duty"].IsNull ? null : Read.Numbers(Json["duty"]); }
        }

        public double? SupplyV
        {
            get { return Json["supply_v"].IsNull ? (double?)null : Json["supply_v"].Number; }
        }

        public double[] Field
        {
            get { return Json["field"].IsNull ? null : Read.Numbers(Json["field"]); }
        }

        public double? ForceN
        {
            get { return Json["force_n"].IsNull ? (double?)null : Json["force_n"].Number; }
        }

        public long? Pin
        {
            get { return Json["pin"].IsNull ? (long?)null : Json["pin"].Integer; }
        }

        public StatusFan Fan
        {
            get { return Json["fan"].IsNull ? null : new StatusFan(Json["fan"]); }
        }

        public StatusOrientation Orientation
        {
            get { return Json["orientation"].IsNull ? null : new StatusOrientation(Json["orientation"]); }
        }

        public ConnectionsConnectionsEffects[] Effects
        {
            get { return Json["effects"].IsNull ? null : Read.List(Json["effects"], one => new ConnectionsConnectionsEffects(one)); }
        }

        public StatusLoop Loop
        {
            get { return Json["loop"].IsNull ? null : new StatusLoop(Json["loop"]); }
        }

        public StatusLink Link
        {
            get { return Json["link"].IsNull ? null : new StatusLink(Json["link"]); }
        }

        public long? AppliedSeq
        {
            get { return Json["applied_seq"].IsNull ? (long?)null : Json["applied_seq"].Integer; }
        }

        public StatusLastTrip LastTrip
        {
            get { return Json["last_trip"].IsNull ? null : new StatusLastTrip(Json["last_trip"]); }
        }

        public StatusPins Pins
        {
            get { return Json["pins"].IsNull ? null : new StatusPins(Json["pins"]); }
        }
    }

    /// <summary>Event of protocol/README.md.</summary>
    public sealed class Event
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Event(Json json)
        {
            Json = json;
        }

        public string Type
        {
            get { return Json["type"].Text; }
        }

        public long TimeNs
        {
            get { return Json["time_ns"].Integer; }
        }

        public string State
        {
            get { return Json["state"].Text; }
        }

        public long? Effect
        {
            get { return Json["effect"].IsNull ? (long?)null : Json["effect"].Integer; }
        }

        public string Slot
        {
            get { return Json["slot"].Text; }
        }

        public long? Seq
        {
            get { return Json["seq"].IsNull ? (long?)null : Json["seq"].Integer; }
        }

        public string Reason
        {
            get { return Json["reason"].Text; }
        }

        public string Remedy
        {
            get { return Json["remedy"].Text; }
        }

        public long? OnsetNs
        {
            get { return Json["onset_ns"].IsNull ? (long?)null : Json["onset_ns"].Integer; }
        }

        public long? OffsetNs
        {
            get { return Json["offset_ns"].IsNull ? (long?)null : Json["offset_ns"].Integer; }
        }

        public PreviewDelivered Delivered
        {
            get { return Json["delivered"].IsNull ? null : new PreviewDelivered(Json["delivered"]); }
        }

        public long? MaskedMs
        {
            get { return Json["masked_ms"].IsNull ? (long?)null : Json["masked_ms"].Integer; }
        }

        public long? MixedMs
        {
            get { return Json["mixed_ms"].IsNull ? (long?)null : Json["mixed_ms"].Integer; }
        }

        public double? LimitA
        {
            get { return Json["limit_a"].IsNull ? (double?)null : Json["limit_a"].Number; }
        }

        public double? TemperatureC
        {
            get { return Json["temperature_c"].IsNull ? (double?)null : Json["temperature_c"].Number; }
        }

        public double? CurrentA
        {
            get { return Json["current_a"].IsNull ? (double?)null : Json["current_a"].Number; }
        }

        public StatusLastTripDisagreement Disagreement
        {
            get { return Json["disagreement"].IsNull ? null : new StatusLastTripDisagreement(Json["disagreement"]); }
        }

        public string Device
        {
            get { return Json["device"].Text; }
        }

        public long? Skipped
        {
            get { return Json["skipped"].IsNull ? (long?)null : Json["skipped"].Integer; }
        }
    }

    /// <summary>Error of protocol/README.md.</summary>
    public sealed class Error
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public Error(Json json)
        {
            Json = json;
        }

        public long Code
        {
            get { return Json["code"].Integer; }
        }

        public string Message
        {
            get { return Json["message"].Text; }
        }

        public ErrorData Data
        {
            get { return Json["data"].IsNull ? null : new ErrorData(Json["data"]); }
        }
    }

    /// <summary>ErrorData of protocol/README.md.</summary>
    public sealed class ErrorData
    {
        /// <summary>All that came, also what this version does not know.</summary>
        public readonly Json Json;

        public ErrorData(Json json)
        {
            Json = json;
        }

        public string Name
        {
            get { return Json["name"].Text; }
        }

        public string Field
        {
            get { return Json["field"].Text; }
        }

        public Json Limit
        {
            get { return Json["limit"]; }
        }

        public Json Value
        {
            get { return Json["value"]; }
        }

        public string State
        {
            get { return Json["state"].Text; }
        }

        public string Reason
        {
            get { return Json["reason"].Text; }
        }

        public string Remedy
        {
            get { return Json["remedy"].Text; }
        }

        public string RoleNeeded
        {
            get { return Json["role_needed"].Text; }
        }

        public long? RetryAfterMs
        {
            get { return Json["retry_after_ms"].IsNull ? (long?)null : Json["retry_after_ms"].Integer; }
        }

        public string Device
        {
            get { return Json["device"].Text; }
        }

        public double? LimitA
        {
            get { return Json["limit_a"].IsNull ? (double?)null : Json["limit_a"].Number; }
        }
    }
}
