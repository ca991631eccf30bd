// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.

namespace Hedgehog
{
    public enum Sense
    {
        Ccw,
        Cw
    }

    public enum Stepping
    {
        Pin,
        Smooth
    }

    public enum Frame
    {
        Device,
        World,
        Coil
    }

    public enum Waveform
    {
        Constant,
        Sine,
        Square,
        Triangle,
        Sawtooth,
        Noise
    }

    public enum OnClose
    {
        Stop,
        Finish
    }

    public enum IfLimited
    {
        Reduce,
        Refuse
    }

    public enum Method
    {
        EffectPulse,
        EffectCircle,
        EffectVibrate,
        EffectHold,
        EffectPlay
    }

    public enum Scope
    {
        Mine,
        All
    }

    /// <summary>The words of the protocol for the enumerations.</summary>
    internal static class Words
    {
        public static string Of(Sense? value)
        {
            if (!value.HasValue) return null;
            switch (value.Value)
            {
                case Sense.Ccw: return "ccw";
                case Sense.Cw: return "cw";
                default: return null;
            }
        }

        public static string Of(Stepping? value)
        {
            if (!value.HasValue) return null;
            switch (value.Value)
            {
                case Stepping.Pin: return "pin";
                case Stepping.Smooth: return "smooth";
                default: return null;
            }
        }

        public static string Of(Frame? value)
        {
            if (!value.HasValue) return null;
            switch (value.Value)
            {
                case Frame.Device: return "device";
                case Frame.World: return "world";
                case Frame.Coil: return "coil";
                default: return null;
            }
        }

        public static string Of(Waveform? value)
        {
            if (!value.HasValue) return null;
            switch (value.Value)
            {
                case Waveform.Constant: return "constant";
                case Waveform.Sine: return "sine";
                case Waveform.Square: return "square";
                case Waveform.Triangle: return "triangle";
                case Waveform.Sawtooth: return "sawtooth";
                case Waveform.Noise: return "noise";
                default: return null;
            }
        }

        public static string Of(OnClose? value)
        {
            if (!value.HasValue) return null;
            switch (value.Value)
            {
                case OnClose.Stop: return "stop";
                case OnClose.Finish: return "finish";
                default: return null;
            }
        }

        public static string Of(IfLimited? value)
        {
            if (!value.HasValue) return null;
            switch (value.Value)
            {
                case IfLimited.Reduce: return "reduce";
                case IfLimited.Refuse: return "refuse";
                default: return null;
            }
        }

        public static string Of(Method? value)
        {
            if (!value.HasValue) return null;
            switch (value.Value)
            {
                case Method.EffectPulse: return "effect.pulse";
                case Method.EffectCircle: return "effect.circle";
                case Method.EffectVibrate: return "effect.vibrate";
                case Method.EffectHold: return "effect.hold";
                case Method.EffectPlay: return "effect.play";
                default: return null;
            }
        }

        public static string Of(Scope? value)
        {
            if (!value.HasValue) return null;
            switch (value.Value)
            {
                case Scope.Mine: return "mine";
                case Scope.All: return "all";
                default: return null;
            }
        }
    }

    /// <summary>What the parameters may be, for checks and for inspectors.</summary>
    public static class Ranges
    {
        public const double LeaseMsMin = 100;
        public const double LeaseMsMax = 10000;
        public const double RingDegMin = 0;
        public const double RingDegMax = 180;
        public const double SpeedPinsSMin = 0.1;
        public const double SpeedPinsSMax = 100;
        public const double LevelMin = 0;
        public const double LevelMax = 1;
        public const double CurrentAMin = 0;
        public const double ForceNMin = 0;
        public const double GainMin = 0;
        public const double GainMax = 1;
        public const double StartAtNsMin = 0;
        public const double DelayMsMin = 0;
        public const double DelayMsMax = 10000;
        public const double AttackMsMin = 0;
        public const double AttackMsMax = 10000;
        public const double FadeMsMin = 0;
        public const double FadeMsMax = 10000;
        public const double AttackLevelMin = 0;
        public const double AttackLevelMax = 1;
        public const double FadeLevelMin = 0;
        public const double FadeLevelMax = 1;
        public const double FrequencyHzMin = 0.5;
        public const double FrequencyHzMax = 250;
        public const double OnFractionMin = 0.05;
        public const double OnFractionMax = 0.95;
        public const double DurationMsMin = 1;
        public const double DurationMsMax = 10000;
        public const double PriorityMin = 0;
        public const double PriorityMax = 9;
        public const double RateMin = 0.1;
        public const double RateMax = 10;
        public const double EffectMin = 1;
        public const double EffectMax = 4294967295;
        public const double LimitMin = 1;
        public const double LimitMax = 1000;
        public const double AzimuthDegMin = -360;
        public const double AzimuthDegMax = 360;
        public const double AmbientCMin = -20;
        public const double AmbientCMax = 60;
        public const double SecondsMin = 1;
        public const double SecondsMax = 600;
        public const double RateHzMin = 0.1;
        public const double RateHzMax = 200;
    }

    /// <summary>Codes of RequestError.</summary>
    public static class ErrorCode
    {
        public const int ParseError = -32700;
        public const int InvalidRequest = -32600;
        public const int MethodNotFound = -32601;
        public const int InvalidParams = -32602;
        public const int InternalError = -32603;
        public const int NotArmed = -32000;
        public const int Busy = -32001;
        public const int NoSuchEffect = -32002;
        public const int Unauthorized = -32003;
        public const int Forbidden = -32004;
        public const int DeviceAbsent = -32005;
        public const int Unsupported = -32006;
        public const int RefusedThermal = -32007;
        public const int NoSuchPattern = -32008;
        public const int Claimed = -32009;
        public const int Armed = -32010;
    }

    /// <summary>Names of RequestError.</summary>
    public static class ErrorName
    {
        public const string ParseError = "parse_error";
        public const string InvalidRequest = "invalid_request";
        public const string MethodNotFound = "method_not_found";
        public const string InvalidParams = "invalid_params";
        public const string InternalError = "internal_error";
        public const string NotArmed = "not_armed";
        public const string Busy = "busy";
        public const string NoSuchEffect = "no_such_effect";
        public const string Unauthorized = "unauthorized";
        public const string Forbidden = "forbidden";
        public const string DeviceAbsent = "device_absent";
        public const string Unsupported = "unsupported";
        public const string RefusedThermal = "refused_thermal";
        public const string NoSuchPattern = "no_such_pattern";
        public const string Claimed = "claimed";
        public const string Armed = "armed";
    }
}
