// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.

using System.Threading.Tasks;

namespace Hedgehog
{
    /// <summary>Methods that wait for their response. Parameters that are null are not sent.</summary>
    public abstract class BlockingMethods
    {
        public abstract Json Call(string method, Params parameters = null);

        /// <summary>The connections, with their start times and effects.</summary>
        public Results.Connections ConnectionList()
        {
            return new Results.Connections(Call("connection.list"));
        }

        /// <summary>Arms the ball once the cause of the stop no longer exists.</summary>
        public Results.State Arm()
        {
            return new Results.State(Call("device.arm"));
        }

        /// <summary>Exclusive use of the ball until release, end of the connection, or expiry of the lease.</summary>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        public Results.Claim Claim(double? leaseMs = null)
        {
            return new Results.Claim(Call("device.claim", new Params()
                .Set("lease_ms", leaseMs)));
        }

        /// <summary>The ball: pins, coils, limits, calibration, identity.</summary>
        public Results.Description Describe()
        {
            return new Results.Description(Call("device.describe"));
        }

        /// <summary>Coils off at the next tick, latched until armed.</summary>
        public Results.State EmergencyStop()
        {
            return new Results.State(Call("device.emergency_stop"));
        }

        /// <summary>Restarts the board in its boot loader, for a firmware update; rejected while armed.</summary>
        public Results.State EnterBootLoader()
        {
            return new Results.State(Call("device.enter_boot_loader"));
        }

        /// <summary>USB and HID devices: which are used, and why the others are not.</summary>
        public Results.Devices List()
        {
            return new Results.Devices(Call("device.list"));
        }

        /// <summary>Releases the claim.</summary>
        public Results.Done Release()
        {
            return new Results.Done(Call("device.release"));
        }

        /// <summary>State of the ball: temperatures, currents, limits, effects.</summary>
        public Results.Status Status()
        {
            return new Results.Status(Call("device.status"));
        }

        /// <summary>The field rotates about an axis, from pin to pin.</summary>
        /// <param name="axis">The axis of the circle</param>
        /// <param name="ringDeg">Angle between the axis and the circle; 90 is the equator; 0 to 180</param>
        /// <param name="speedPinsS">Steps a second; a step is the pitch of the pins; 0.1 to 100</param>
        /// <param name="sense">As seen from outside along the axis</param>
        /// <param name="stepping">From pin to pin, or gliding</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public Results.Admission Circle(Direction axis = null, double? ringDeg = null, double? speedPinsS = null, Sense? sense = null, Stepping? stepping = null, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(Call("effect.circle", new Params()
                .Set("axis", axis)
                .Set("ring_deg", ringDeg)
                .Set("speed_pins_s", speedPinsS)
                .Set("sense", Words.Of(sense))
                .Set("stepping", Words.Of(stepping))
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))));
        }

        /// <summary>A push that lasts as long as it is renewed.</summary>
        /// <param name="direction">Where the pins push out</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public Results.Admission Hold(Direction direction, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(Call("effect.hold", new Params()
                .Set("direction", direction)
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))));
        }

        /// <summary>How long effects took from their request to the board.</summary>
        public Results.Latency Latency()
        {
            return new Results.Latency(Call("effect.latency"));
        }

        /// <summary>Plays key frames, of a named pattern or its own.</summary>
        /// <param name="pattern">The name of a pattern, or keyframes instead</param>
        /// <param name="keyframes">Where and how strongly, at points in time; t_ms never falls</param>
        /// <param name="rotateTo">Patterns face front; this turns the front there by the shortest way</param>
        /// <param name="rate">So many times as fast; 0.1 to 10</param>
        /// <param name="loop">Begins again at its end</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public Results.Admission Play(string pattern = null, Params[] keyframes = null, Direction rotateTo = null, double? rate = null, bool? loop = null, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(Call("effect.play", new Params()
                .Set("pattern", pattern)
                .Set("keyframes", keyframes)
                .Set("rotate_to", rotateTo)
                .Set("rate", rate)
                .Set("loop", loop)
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))));
        }

        /// <summary>Computes currents and temperatures of an effect without starting it.</summary>
        /// <param name="method">A method that plays</param>
        /// <param name="params">The parameters of that method</param>
        public Results.Preview Preview(Method method, Params @params)
        {
            return new Results.Preview(Call("effect.preview", new Params()
                .Set("method", Words.Of(method))
                .Set("params", @params)));
        }

        /// <summary>One push towards a direction.</summary>
        /// <param name="direction">Where the pins push out</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public Results.Admission Pulse(Direction direction, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(Call("effect.pulse", new Params()
                .Set("direction", direction)
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))));
        }

        /// <summary>Ends one of the connection's own effects.</summary>
        /// <param name="effect">The number of an effect, from its admission; 1 to 4294967295</param>
        /// <param name="slot">The connection's own name for an effect</param>
        public Results.Stopped Stop(long? effect = null, string slot = null)
        {
            return new Results.Stopped(Call("effect.stop", new Params()
                .Set("effect", effect)
                .Set("slot", slot)));
        }

        /// <summary>Ends all effects of the connection, or of all connections.</summary>
        /// <param name="scope">"all" for effects of others too</param>
        public Results.Stopped StopAll(Scope? scope = null)
        {
            return new Results.Stopped(Call("effect.stop_all", new Params()
                .Set("scope", Words.Of(scope))));
        }

        /// <summary>Changes a playing effect and renews its lease.</summary>
        /// <param name="effect">The number of an effect, from its admission; 1 to 4294967295</param>
        /// <param name="direction">Where the pins push out</param>
        /// <param name="pattern">The name of a pattern, or keyframes instead</param>
        /// <param name="keyframes">Where and how strongly, at points in time; t_ms never falls</param>
        /// <param name="rotateTo">Patterns face front; this turns the front there by the shortest way</param>
        /// <param name="rate">So many times as fast; 0.1 to 10</param>
        /// <param name="loop">Begins again at its end</param>
        /// <param name="axis">The axis of the circle</param>
        /// <param name="ringDeg">Angle between the axis and the circle; 90 is the equator; 0 to 180</param>
        /// <param name="speedPinsS">Steps a second; a step is the pitch of the pins; 0.1 to 100</param>
        /// <param name="sense">As seen from outside along the axis</param>
        /// <param name="stepping">From pin to pin, or gliding</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public Results.Admission Update(long? effect = null, Direction direction = null, string pattern = null, Params[] keyframes = null, Direction rotateTo = null, double? rate = null, bool? loop = null, Direction axis = null, double? ringDeg = null, double? speedPinsS = null, Sense? sense = null, Stepping? stepping = null, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(Call("effect.update", new Params()
                .Set("effect", effect)
                .Set("direction", direction)
                .Set("pattern", pattern)
                .Set("keyframes", keyframes)
                .Set("rotate_to", rotateTo)
                .Set("rate", rate)
                .Set("loop", loop)
                .Set("axis", axis)
                .Set("ring_deg", ringDeg)
                .Set("speed_pins_s", speedPinsS)
                .Set("sense", Words.Of(sense))
                .Set("stepping", Words.Of(stepping))
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))));
        }

        /// <summary>A push with a waveform.</summary>
        /// <param name="direction">Where the pins push out</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public Results.Admission Vibrate(Direction direction = null, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(Call("effect.vibrate", new Params()
                .Set("direction", direction)
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))));
        }

        /// <summary>Past events, including those before the last start.</summary>
        /// <param name="since">Not before this time, RFC 3339</param>
        /// <param name="types">Names of events; default all</param>
        /// <param name="trips">See protocol/README.md</param>
        /// <param name="limit">The newest so many; 1 to 1000</param>
        public Results.History EventsHistory(string since = null, string[] types = null, bool? trips = null, long? limit = null)
        {
            return new Results.History(Call("events.history", new Params()
                .Set("since", since)
                .Set("types", types)
                .Set("trips", trips)
                .Set("limit", limit)));
        }

        /// <summary>Subscribes to notifications of events.</summary>
        /// <param name="types">Names of events; default all</param>
        /// <param name="scope">"all" for effects of others too</param>
        public Results.EventsSubscription EventsSubscribe(string[] types = null, Scope? scope = null)
        {
            return new Results.EventsSubscription(Call("events.subscribe", new Params()
                .Set("types", types)
                .Set("scope", Words.Of(scope))));
        }

        /// <summary>Ends the subscription to events.</summary>
        public Results.Done EventsUnsubscribe()
        {
            return new Results.Done(Call("events.unsubscribe"));
        }

        /// <summary>Sets the azimuth of the ball's front.</summary>
        /// <param name="azimuthDeg">Anticlockwise seen from above; -360 to 360</param>
        public Results.Recentered OrientationRecenter(double? azimuthDeg = null)
        {
            return new Results.Recentered(Call("orientation.recenter", new Params()
                .Set("azimuth_deg", azimuthDeg)));
        }

        /// <summary>Sets the orientation measured by an external sensor.</summary>
        /// <param name="quaternion">Device to world, of length 1</param>
        public Results.Done OrientationSet(Params quaternion)
        {
            return new Results.Done(Call("orientation.set", new Params()
                .Set("quaternion", quaternion)));
        }

        /// <summary>Gain applied to all effects; persistent.</summary>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        public Results.Gain OutputSetGain(double gain)
        {
            return new Results.Gain(Call("output.set_gain", new Params()
                .Set("gain", gain)));
        }

        /// <summary>One named pattern with its key frames.</summary>
        /// <param name="name">Of a pattern: vendor/name, or that of a shipped one</param>
        public Results.Pattern PatternGet(string name)
        {
            return new Results.Pattern(Call("pattern.get", new Params()
                .Set("name", name)));
        }

        /// <summary>Lists the named patterns.</summary>
        public Results.Patterns PatternList()
        {
            return new Results.Patterns(Call("pattern.list"));
        }

        /// <summary>Stores a pattern under vendor/name.</summary>
        /// <param name="name">Of a pattern: vendor/name, or that of a shipped one</param>
        /// <param name="keyframes">Where and how strongly, at points in time; t_ms never falls</param>
        /// <param name="description">One sentence for whoever chooses a pattern</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        public Results.PatternSummary PatternPut(string name, Params[] keyframes, string description = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null)
        {
            return new Results.PatternSummary(Call("pattern.put", new Params()
                .Set("name", name)
                .Set("keyframes", keyframes)
                .Set("description", description)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)));
        }

        /// <summary>Removes a stored pattern.</summary>
        /// <param name="name">Of a pattern: vendor/name, or that of a shipped one</param>
        public Results.Done PatternRemove(string name)
        {
            return new Results.Done(Call("pattern.remove", new Params()
                .Set("name", name)));
        }

        /// <summary>The device time.</summary>
        public Results.Ping Ping()
        {
            return new Results.Ping(Call("ping"));
        }

        /// <summary>Sets orientation, ambient temperature and faults of the simulation.</summary>
        /// <param name="orientation">Device to world, of length 1</param>
        /// <param name="ambientC">Temperature of the simulated room; -20 to 60</param>
        /// <param name="fault">Replaces all simulated faults; {} clears them</param>
        /// <param name="errors">Replaces all errors of measurement and of the ball; [] ends them</param>
        public Results.SimulatedWorld SimSet(Params orientation = null, double? ambientC = null, Params fault = null, Params[] errors = null)
        {
            return new Results.SimulatedWorld(Call("sim.set", new Params()
                .Set("orientation", orientation)
                .Set("ambient_c", ambientC)
                .Set("fault", fault)
                .Set("errors", errors)));
        }

        /// <summary>True state of the simulated ball.</summary>
        public Results.SimulatedTruth SimTruth()
        {
            return new Results.SimulatedTruth(Call("sim.truth"));
        }

        /// <summary>Temperatures and currents of the last minutes.</summary>
        /// <param name="seconds">1 to 600</param>
        public Results.TelemetryHistory TelemetryHistory(double? seconds = null)
        {
            return new Results.TelemetryHistory(Call("telemetry.history", new Params()
                .Set("seconds", seconds)));
        }

        /// <summary>Subscribes to periodic notifications of the status.</summary>
        /// <param name="rateHz">0.1 to 200</param>
        /// <param name="fields">Keys of the status object; default all but pins</param>
        public Results.TelemetrySubscription TelemetrySubscribe(double? rateHz = null, string[] fields = null)
        {
            return new Results.TelemetrySubscription(Call("telemetry.subscribe", new Params()
                .Set("rate_hz", rateHz)
                .Set("fields", fields)));
        }

        /// <summary>Ends the subscription to telemetry.</summary>
        public Results.Done TelemetryUnsubscribe()
        {
            return new Results.Done(Call("telemetry.unsubscribe"));
        }

        /// <summary>How long a current or an effect can flow.</summary>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="direction">Where the pins push out</param>
        /// <param name="method">A method that plays</param>
        /// <param name="params">The parameters of that method</param>
        /// <param name="effect">The number of an effect, from its admission; 1 to 4294967295</param>
        public Results.Forecast ThermalForecast(double? currentA = null, Direction direction = null, Method? method = null, Params @params = null, long? effect = null)
        {
            return new Results.Forecast(Call("thermal.forecast", new Params()
                .Set("current_a", currentA)
                .Set("direction", direction)
                .Set("method", Words.Of(method))
                .Set("params", @params)
                .Set("effect", effect)));
        }
    }

    /// <summary>The same as tasks. Parameters that are null are not sent.</summary>
    public abstract class AsyncMethods
    {
        public abstract Task<Json> Call(string method, Params parameters = null);

        /// <summary>The connections, with their start times and effects.</summary>
        public async Task<Results.Connections> ConnectionList()
        {
            return new Results.Connections(await Call("connection.list").ConfigureAwait(false));
        }

        /// <summary>Arms the ball once the cause of the stop no longer exists.</summary>
        public async Task<Results.State> Arm()
        {
            return new Results.State(await Call("device.arm").ConfigureAwait(false));
        }

        /// <summary>Exclusive use of the ball until release, end of the connection, or expiry of the lease.</summary>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        public async Task<Results.Claim> Claim(double? leaseMs = null)
        {
            return new Results.Claim(await Call("device.claim", new Params()
                .Set("lease_ms", leaseMs)).ConfigureAwait(false));
        }

        /// <summary>The ball: pins, coils, limits, calibration, identity.</summary>
        public async Task<Results.Description> Describe()
        {
            return new Results.Description(await Call("device.describe").ConfigureAwait(false));
        }

        /// <summary>Coils off at the next tick, latched until armed.</summary>
        public async Task<Results.State> EmergencyStop()
        {
            return new Results.State(await Call("device.emergency_stop").ConfigureAwait(false));
        }

        /// <summary>Restarts the board in its boot loader, for a firmware update; rejected while armed.</summary>
        public async Task<Results.State> EnterBootLoader()
        {
            return new Results.State(await Call("device.enter_boot_loader").ConfigureAwait(false));
        }

        /// <summary>USB and HID devices: which are used, and why the others are not.</summary>
        public async Task<Results.Devices> List()
        {
            return new Results.Devices(await Call("device.list").ConfigureAwait(false));
        }

        /// <summary>Releases the claim.</summary>
        public async Task<Results.Done> Release()
        {
            return new Results.Done(await Call("device.release").ConfigureAwait(false));
        }

        /// <summary>State of the ball: temperatures, currents, limits, effects.</summary>
        public async Task<Results.Status> Status()
        {
            return new Results.Status(await Call("device.status").ConfigureAwait(false));
        }

        /// <summary>The field rotates about an axis, from pin to pin.</summary>
        /// <param name="axis">The axis of the circle</param>
        /// <param name="ringDeg">Angle between the axis and the circle; 90 is the equator; 0 to 180</param>
        /// <param name="speedPinsS">Steps a second; a step is the pitch of the pins; 0.1 to 100</param>
        /// <param name="sense">As seen from outside along the axis</param>
        /// <param name="stepping">From pin to pin, or gliding</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public async Task<Results.Admission> Circle(Direction axis = null, double? ringDeg = null, double? speedPinsS = null, Sense? sense = null, Stepping? stepping = null, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(await Call("effect.circle", new Params()
                .Set("axis", axis)
                .Set("ring_deg", ringDeg)
                .Set("speed_pins_s", speedPinsS)
                .Set("sense", Words.Of(sense))
                .Set("stepping", Words.Of(stepping))
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))).ConfigureAwait(false));
        }

        /// <summary>A push that lasts as long as it is renewed.</summary>
        /// <param name="direction">Where the pins push out</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public async Task<Results.Admission> Hold(Direction direction, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(await Call("effect.hold", new Params()
                .Set("direction", direction)
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))).ConfigureAwait(false));
        }

        /// <summary>How long effects took from their request to the board.</summary>
        public async Task<Results.Latency> Latency()
        {
            return new Results.Latency(await Call("effect.latency").ConfigureAwait(false));
        }

        /// <summary>Plays key frames, of a named pattern or its own.</summary>
        /// <param name="pattern">The name of a pattern, or keyframes instead</param>
        /// <param name="keyframes">Where and how strongly, at points in time; t_ms never falls</param>
        /// <param name="rotateTo">Patterns face front; this turns the front there by the shortest way</param>
        /// <param name="rate">So many times as fast; 0.1 to 10</param>
        /// <param name="loop">Begins again at its end</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public async Task<Results.Admission> Play(string pattern = null, Params[] keyframes = null, Direction rotateTo = null, double? rate = null, bool? loop = null, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(await Call("effect.play", new Params()
                .Set("pattern", pattern)
                .Set("keyframes", keyframes)
                .Set("rotate_to", rotateTo)
                .Set("rate", rate)
                .Set("loop", loop)
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))).ConfigureAwait(false));
        }

        /// <summary>Computes currents and temperatures of an effect without starting it.</summary>
        /// <param name="method">A method that plays</param>
        /// <param name="params">The parameters of that method</param>
        public async Task<Results.Preview> Preview(Method method, Params @params)
        {
            return new Results.Preview(await Call("effect.preview", new Params()
                .Set("method", Words.Of(method))
                .Set("params", @params)).ConfigureAwait(false));
        }

        /// <summary>One push towards a direction.</summary>
        /// <param name="direction">Where the pins push out</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public async Task<Results.Admission> Pulse(Direction direction, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(await Call("effect.pulse", new Params()
                .Set("direction", direction)
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))).ConfigureAwait(false));
        }

        /// <summary>Ends one of the connection's own effects.</summary>
        /// <param name="effect">The number of an effect, from its admission; 1 to 4294967295</param>
        /// <param name="slot">The connection's own name for an effect</param>
        public async Task<Results.Stopped> Stop(long? effect = null, string slot = null)
        {
            return new Results.Stopped(await Call("effect.stop", new Params()
                .Set("effect", effect)
                .Set("slot", slot)).ConfigureAwait(false));
        }

        /// <summary>Ends all effects of the connection, or of all connections.</summary>
        /// <param name="scope">"all" for effects of others too</param>
        public async Task<Results.Stopped> StopAll(Scope? scope = null)
        {
            return new Results.Stopped(await Call("effect.stop_all", new Params()
                .Set("scope", Words.Of(scope))).ConfigureAwait(false));
        }

        /// <summary>Changes a playing effect and renews its lease.</summary>
        /// <param name="effect">The number of an effect, from its admission; 1 to 4294967295</param>
        /// <param name="direction">Where the pins push out</param>
        /// <param name="pattern">The name of a pattern, or keyframes instead</param>
        /// <param name="keyframes">Where and how strongly, at points in time; t_ms never falls</param>
        /// <param name="rotateTo">Patterns face front; this turns the front there by the shortest way</param>
        /// <param name="rate">So many times as fast; 0.1 to 10</param>
        /// <param name="loop">Begins again at its end</param>
        /// <param name="axis">The axis of the circle</param>
        /// <param name="ringDeg">Angle between the axis and the circle; 90 is the equator; 0 to 180</param>
        /// <param name="speedPinsS">Steps a second; a step is the pitch of the pins; 0.1 to 100</param>
        /// <param name="sense">As seen from outside along the axis</param>
        /// <param name="stepping">From pin to pin, or gliding</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public async Task<Results.Admission> Update(long? effect = null, Direction direction = null, string pattern = null, Params[] keyframes = null, Direction rotateTo = null, double? rate = null, bool? loop = null, Direction axis = null, double? ringDeg = null, double? speedPinsS = null, Sense? sense = null, Stepping? stepping = null, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(await Call("effect.update", new Params()
                .Set("effect", effect)
                .Set("direction", direction)
                .Set("pattern", pattern)
                .Set("keyframes", keyframes)
                .Set("rotate_to", rotateTo)
                .Set("rate", rate)
                .Set("loop", loop)
                .Set("axis", axis)
                .Set("ring_deg", ringDeg)
                .Set("speed_pins_s", speedPinsS)
                .Set("sense", Words.Of(sense))
                .Set("stepping", Words.Of(stepping))
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))).ConfigureAwait(false));
        }

        /// <summary>A push with a waveform.</summary>
        /// <param name="direction">Where the pins push out</param>
        /// <param name="frame">The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A)</param>
        /// <param name="level">Strength as a part of limits.current_a; 0 to 1</param>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="forceN">Strength as the force on the pin that is pointed at; at least 0</param>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        /// <param name="startAtNs">Device time of the onset; at least 0</param>
        /// <param name="delayMs">From now to the onset; 0 to 10000</param>
        /// <param name="attackMs">Linear rise, inside the duration; 0 to 10000</param>
        /// <param name="fadeMs">Linear fall, inside the duration; not with a lease; 0 to 10000</param>
        /// <param name="attackLevel">Where the rise begins, as a part of the strength; 0 to 1</param>
        /// <param name="fadeLevel">Where the fall ends, as a part of the strength; 0 to 1</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        /// <param name="durationMs">The effect ends after it. Never together with lease_ms; 1 to 10000</param>
        /// <param name="leaseMs">Ends after it unless renewed; 100 to 10000</param>
        /// <param name="onClose">"finish" lets an effect of up to 2000 ms play out after the connection ended</param>
        /// <param name="slot">The connection's own name for an effect</param>
        /// <param name="priority">Only effects of the highest active priority are output; 8 and 9 need the role operate; 0 to 9</param>
        /// <param name="ifLimited">"refuse": an error instead of a reduced effect</param>
        public async Task<Results.Admission> Vibrate(Direction direction = null, Frame? frame = null, double? level = null, double? currentA = null, double? forceN = null, double? gain = null, long? startAtNs = null, double? delayMs = null, double? attackMs = null, double? fadeMs = null, double? attackLevel = null, double? fadeLevel = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null, double? durationMs = null, double? leaseMs = null, OnClose? onClose = null, string slot = null, long? priority = null, IfLimited? ifLimited = null)
        {
            return new Results.Admission(await Call("effect.vibrate", new Params()
                .Set("direction", direction)
                .Set("frame", Words.Of(frame))
                .Set("level", level)
                .Set("current_a", currentA)
                .Set("force_n", forceN)
                .Set("gain", gain)
                .Set("start_at_ns", startAtNs)
                .Set("delay_ms", delayMs)
                .Set("attack_ms", attackMs)
                .Set("fade_ms", fadeMs)
                .Set("attack_level", attackLevel)
                .Set("fade_level", fadeLevel)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)
                .Set("duration_ms", durationMs)
                .Set("lease_ms", leaseMs)
                .Set("on_close", Words.Of(onClose))
                .Set("slot", slot)
                .Set("priority", priority)
                .Set("if_limited", Words.Of(ifLimited))).ConfigureAwait(false));
        }

        /// <summary>Past events, including those before the last start.</summary>
        /// <param name="since">Not before this time, RFC 3339</param>
        /// <param name="types">Names of events; default all</param>
        /// <param name="trips">See protocol/README.md</param>
        /// <param name="limit">The newest so many; 1 to 1000</param>
        public async Task<Results.History> EventsHistory(string since = null, string[] types = null, bool? trips = null, long? limit = null)
        {
            return new Results.History(await Call("events.history", new Params()
                .Set("since", since)
                .Set("types", types)
                .Set("trips", trips)
                .Set("limit", limit)).ConfigureAwait(false));
        }

        /// <summary>Subscribes to notifications of events.</summary>
        /// <param name="types">Names of events; default all</param>
        /// <param name="scope">"all" for effects of others too</param>
        public async Task<Results.EventsSubscription> EventsSubscribe(string[] types = null, Scope? scope = null)
        {
            return new Results.EventsSubscription(await Call("events.subscribe", new Params()
                .Set("types", types)
                .Set("scope", Words.Of(scope))).ConfigureAwait(false));
        }

        /// <summary>Ends the subscription to events.</summary>
        public async Task<Results.Done> EventsUnsubscribe()
        {
            return new Results.Done(await Call("events.unsubscribe").ConfigureAwait(false));
        }

        /// <summary>Sets the azimuth of the ball's front.</summary>
        /// <param name="azimuthDeg">Anticlockwise seen from above; -360 to 360</param>
        public async Task<Results.Recentered> OrientationRecenter(double? azimuthDeg = null)
        {
            return new Results.Recentered(await Call("orientation.recenter", new Params()
                .Set("azimuth_deg", azimuthDeg)).ConfigureAwait(false));
        }

        /// <summary>Sets the orientation measured by an external sensor.</summary>
        /// <param name="quaternion">Device to world, of length 1</param>
        public async Task<Results.Done> OrientationSet(Params quaternion)
        {
            return new Results.Done(await Call("orientation.set", new Params()
                .Set("quaternion", quaternion)).ConfigureAwait(false));
        }

        /// <summary>Gain applied to all effects; persistent.</summary>
        /// <param name="gain">Multiplies the strength; 0 to 1</param>
        public async Task<Results.Gain> OutputSetGain(double gain)
        {
            return new Results.Gain(await Call("output.set_gain", new Params()
                .Set("gain", gain)).ConfigureAwait(false));
        }

        /// <summary>One named pattern with its key frames.</summary>
        /// <param name="name">Of a pattern: vendor/name, or that of a shipped one</param>
        public async Task<Results.Pattern> PatternGet(string name)
        {
            return new Results.Pattern(await Call("pattern.get", new Params()
                .Set("name", name)).ConfigureAwait(false));
        }

        /// <summary>Lists the named patterns.</summary>
        public async Task<Results.Patterns> PatternList()
        {
            return new Results.Patterns(await Call("pattern.list").ConfigureAwait(false));
        }

        /// <summary>Stores a pattern under vendor/name.</summary>
        /// <param name="name">Of a pattern: vendor/name, or that of a shipped one</param>
        /// <param name="keyframes">Where and how strongly, at points in time; t_ms never falls</param>
        /// <param name="description">One sentence for whoever chooses a pattern</param>
        /// <param name="waveform">Runs between 0 and the strength</param>
        /// <param name="frequencyHz">0.5 to 250</param>
        /// <param name="onFraction">The part of a period that a square is on; 0.05 to 0.95</param>
        public async Task<Results.PatternSummary> PatternPut(string name, Params[] keyframes, string description = null, Waveform? waveform = null, double? frequencyHz = null, double? onFraction = null)
        {
            return new Results.PatternSummary(await Call("pattern.put", new Params()
                .Set("name", name)
                .Set("keyframes", keyframes)
                .Set("description", description)
                .Set("waveform", Words.Of(waveform))
                .Set("frequency_hz", frequencyHz)
                .Set("on_fraction", onFraction)).ConfigureAwait(false));
        }

        /// <summary>Removes a stored pattern.</summary>
        /// <param name="name">Of a pattern: vendor/name, or that of a shipped one</param>
        public async Task<Results.Done> PatternRemove(string name)
        {
            return new Results.Done(await Call("pattern.remove", new Params()
                .Set("name", name)).ConfigureAwait(false));
        }

        /// <summary>The device time.</summary>
        public async Task<Results.Ping> Ping()
        {
            return new Results.Ping(await Call("ping").ConfigureAwait(false));
        }

        /// <summary>Sets orientation, ambient temperature and faults of the simulation.</summary>
        /// <param name="orientation">Device to world, of length 1</param>
        /// <param name="ambientC">Temperature of the simulated room; -20 to 60</param>
        /// <param name="fault">Replaces all simulated faults; {} clears them</param>
        /// <param name="errors">Replaces all errors of measurement and of the ball; [] ends them</param>
        public async Task<Results.SimulatedWorld> SimSet(Params orientation = null, double? ambientC = null, Params fault = null, Params[] errors = null)
        {
            return new Results.SimulatedWorld(await Call("sim.set", new Params()
                .Set("orientation", orientation)
                .Set("ambient_c", ambientC)
                .Set("fault", fault)
                .Set("errors", errors)).ConfigureAwait(false));
        }

        /// <summary>True state of the simulated ball.</summary>
        public async Task<Results.SimulatedTruth> SimTruth()
        {
            return new Results.SimulatedTruth(await Call("sim.truth").ConfigureAwait(false));
        }

        /// <summary>Temperatures and currents of the last minutes.</summary>
        /// <param name="seconds">1 to 600</param>
        public async Task<Results.TelemetryHistory> TelemetryHistory(double? seconds = null)
        {
            return new Results.TelemetryHistory(await Call("telemetry.history", new Params()
                .Set("seconds", seconds)).ConfigureAwait(false));
        }

        /// <summary>Subscribes to periodic notifications of the status.</summary>
        /// <param name="rateHz">0.1 to 200</param>
        /// <param name="fields">Keys of the status object; default all but pins</param>
        public async Task<Results.TelemetrySubscription> TelemetrySubscribe(double? rateHz = null, string[] fields = null)
        {
            return new Results.TelemetrySubscription(await Call("telemetry.subscribe", new Params()
                .Set("rate_hz", rateHz)
                .Set("fields", fields)).ConfigureAwait(false));
        }

        /// <summary>Ends the subscription to telemetry.</summary>
        public async Task<Results.Done> TelemetryUnsubscribe()
        {
            return new Results.Done(await Call("telemetry.unsubscribe").ConfigureAwait(false));
        }

        /// <summary>How long a current or an effect can flow.</summary>
        /// <param name="currentA">Strength as a current; at most limits.current_a; at least 0</param>
        /// <param name="direction">Where the pins push out</param>
        /// <param name="method">A method that plays</param>
        /// <param name="params">The parameters of that method</param>
        /// <param name="effect">The number of an effect, from its admission; 1 to 4294967295</param>
        public async Task<Results.Forecast> ThermalForecast(double? currentA = null, Direction direction = null, Method? method = null, Params @params = null, long? effect = null)
        {
            return new Results.Forecast(await Call("thermal.forecast", new Params()
                .Set("current_a", currentA)
                .Set("direction", direction)
                .Set("method", Words.Of(method))
                .Set("params", @params)
                .Set("effect", effect)).ConfigureAwait(false));
        }
    }
}
