// SPDX-License-Identifier: MIT
namespace Hedgehog
{
    /// <summary>What the daemon tells unasked, after EventsSubscribe or TelemetrySubscribe.</summary>
    public sealed class Notification
    {
        /// <summary>"event", "telemetry", or one that this version does not know.</summary>
        public readonly string Method;
        public readonly Json Params;

        internal Notification(string method, Json parameters)
        {
            Method = method;
            Params = parameters;
        }

        /// <summary>null: it is none.</summary>
        public Results.Event Event
        {
            get { return Method == "event" ? new Results.Event(Params) : null; }
        }

        /// <summary>null: it is none. Has the fields that were asked for.</summary>
        public Results.Telemetry Telemetry
        {
            get { return Method == "telemetry" ? new Results.Telemetry(Params) : null; }
        }
    }
}
