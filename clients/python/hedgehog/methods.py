# SPDX-License-Identifier: MIT
# Written by generate.py from protocol/schema/openrpc.json.
"""The daemon's methods. Parameters that are None are left out; protocol/README.md has all of them at length."""

from typing import Any, Mapping, Optional, Sequence

from .messages import (
    Admission, Claim, Connections, Description, Devices, Direction, Done, Fault, Forecast, Frame, Gain,
    History, IfLimited, Latency, Method, OnClose, Pattern, PatternKeyframes, PatternSummary,
    PatternWaveform, Patterns, Ping, Preview, Recentered, Scope, Sense, SimulatedTruth, SimulatedWorld,
    SimulatedWorldErrors, State, Status, StatusOrientationQuaternion, Stepping, Stopped, TelemetryHistory,
)


class Methods:
    """Methods that wait for their response."""

    def call(self, method: str, /, **params: Any) -> Any:
        raise NotImplementedError

    def connection_list(self) -> Connections:
        """The connections, with their start times and effects."""
        result: Connections = self.call("connection.list")
        return result

    def arm(self) -> State:
        """Arms the ball once the cause of the stop no longer exists."""
        result: State = self.call("device.arm")
        return result

    def claim(self, *, lease_ms: Optional[float] = None) -> Claim:
        """Exclusive use of the ball until release, end of the connection, or expiry of the lease.

        lease_ms: Ends after it unless renewed; 100 to 10000
        """
        result: Claim = self.call("device.claim", lease_ms=lease_ms)
        return result

    def describe(self) -> Description:
        """The ball: pins, coils, limits, calibration, identity."""
        result: Description = self.call("device.describe")
        return result

    def emergency_stop(self) -> State:
        """Coils off at the next tick, latched until armed."""
        result: State = self.call("device.emergency_stop")
        return result

    def enter_boot_loader(self) -> State:
        """Restarts the board in its boot loader, for a firmware update; rejected while armed."""
        result: State = self.call("device.enter_boot_loader")
        return result

    def list(self) -> Devices:
        """USB and HID devices: which are used, and why the others are not."""
        result: Devices = self.call("device.list")
        return result

    def release(self) -> Done:
        """Releases the claim."""
        result: Done = self.call("device.release")
        return result

    def status(self) -> Status:
        """State of the ball: temperatures, currents, limits, effects."""
        result: Status = self.call("device.status")
        return result

    def circle(self, axis: Optional[Direction] = None, *, ring_deg: Optional[float] = None,
               speed_pins_s: Optional[float] = None, sense: Optional[Sense] = None,
               stepping: Optional[Stepping] = None, frame: Optional[Frame] = None,
               level: Optional[float] = None, current_a: Optional[float] = None,
               force_n: Optional[float] = None, gain: Optional[float] = None, start_at_ns: Optional[int] = None,
               delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
               fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
               fade_level: Optional[float] = None, waveform: Optional[PatternWaveform] = None,
               frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
               duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
               on_close: Optional[OnClose] = None, slot: Optional[str] = None, priority: Optional[int] = None,
               if_limited: Optional[IfLimited] = None) -> Admission:
        """The field rotates about an axis, from pin to pin.

        axis: The axis of the circle
        ring_deg: Angle between the axis and the circle; 90 is the equator; 0 to 180
        speed_pins_s: Steps a second; a step is the pitch of the pins; 0.1 to 100
        sense: As seen from outside along the axis; ccw, cw
        stepping: From pin to pin, or gliding; pin, smooth
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = self.call("effect.circle", axis=axis, ring_deg=ring_deg, speed_pins_s=speed_pins_s,
            sense=sense, stepping=stepping, frame=frame, level=level, current_a=current_a, force_n=force_n,
            gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms, attack_ms=attack_ms, fade_ms=fade_ms,
            attack_level=attack_level, fade_level=fade_level, waveform=waveform, frequency_hz=frequency_hz,
            on_fraction=on_fraction, duration_ms=duration_ms, lease_ms=lease_ms, on_close=on_close, slot=slot,
            priority=priority, if_limited=if_limited)
        return result

    def hold(self, direction: Direction, *, frame: Optional[Frame] = None, level: Optional[float] = None,
             current_a: Optional[float] = None, force_n: Optional[float] = None, gain: Optional[float] = None,
             start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
             attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
             attack_level: Optional[float] = None, fade_level: Optional[float] = None,
             waveform: Optional[PatternWaveform] = None, frequency_hz: Optional[float] = None,
             on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
             lease_ms: Optional[float] = None, on_close: Optional[OnClose] = None, slot: Optional[str] = None,
             priority: Optional[int] = None, if_limited: Optional[IfLimited] = None) -> Admission:
        """A push that lasts as long as it is renewed.

        direction: Where the pins push out
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = self.call("effect.hold", direction=direction, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)
        return result

    def latency(self) -> Latency:
        """How long effects took from their request to the board."""
        result: Latency = self.call("effect.latency")
        return result

    def play(self, pattern: Optional[str] = None, *, keyframes: Optional[Sequence[PatternKeyframes]] = None,
             rotate_to: Optional[Direction] = None, rate: Optional[float] = None, loop: Optional[bool] = None,
             frame: Optional[Frame] = None, level: Optional[float] = None, current_a: Optional[float] = None,
             force_n: Optional[float] = None, gain: Optional[float] = None, start_at_ns: Optional[int] = None,
             delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
             fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
             fade_level: Optional[float] = None, waveform: Optional[PatternWaveform] = None,
             frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
             duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
             on_close: Optional[OnClose] = None, slot: Optional[str] = None, priority: Optional[int] = None,
             if_limited: Optional[IfLimited] = None) -> Admission:
        """Plays key frames, of a named pattern or its own.

        pattern: The name of a pattern, or keyframes instead
        keyframes: Where and how strongly, at points in time; t_ms never falls
        rotate_to: Patterns face front; this turns the front there by the shortest way
        rate: So many times as fast; 0.1 to 10
        loop: Begins again at its end
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = self.call("effect.play", pattern=pattern, keyframes=keyframes, rotate_to=rotate_to,
            rate=rate, loop=loop, frame=frame, level=level, current_a=current_a, force_n=force_n, gain=gain,
            start_at_ns=start_at_ns, delay_ms=delay_ms, attack_ms=attack_ms, fade_ms=fade_ms,
            attack_level=attack_level, fade_level=fade_level, waveform=waveform, frequency_hz=frequency_hz,
            on_fraction=on_fraction, duration_ms=duration_ms, lease_ms=lease_ms, on_close=on_close, slot=slot,
            priority=priority, if_limited=if_limited)
        return result

    def preview(self, method: Method, params: Mapping[str, Any]) -> Preview:
        """Computes currents and temperatures of an effect without starting it.

        method: A method that plays; effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play
        params: The parameters of that method
        """
        result: Preview = self.call("effect.preview", method=method, params=params)
        return result

    def pulse(self, direction: Direction, *, frame: Optional[Frame] = None, level: Optional[float] = None,
              current_a: Optional[float] = None, force_n: Optional[float] = None, gain: Optional[float] = None,
              start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
              attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
              attack_level: Optional[float] = None, fade_level: Optional[float] = None,
              waveform: Optional[PatternWaveform] = None, frequency_hz: Optional[float] = None,
              on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
              lease_ms: Optional[float] = None, on_close: Optional[OnClose] = None, slot: Optional[str] = None,
              priority: Optional[int] = None, if_limited: Optional[IfLimited] = None) -> Admission:
        """One push towards a direction.

        direction: Where the pins push out
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = self.call("effect.pulse", direction=direction, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)
        return result

    def stop(self, *, effect: Optional[int] = None, slot: Optional[str] = None) -> Stopped:
        """Ends one of the connection's own effects.

        effect: The number of an effect, from its admission; 1 to 4294967295
        slot: The connection's own name for an effect
        """
        result: Stopped = self.call("effect.stop", effect=effect, slot=slot)
        return result

    def stop_all(self, *, scope: Optional[Scope] = None) -> Stopped:
        """Ends all effects of the connection, or of all connections.

        scope: "all" for effects of others too; mine, all
        """
        result: Stopped = self.call("effect.stop_all", scope=scope)
        return result

    def update(self, *, effect: Optional[int] = None, direction: Optional[Direction] = None,
               pattern: Optional[str] = None, keyframes: Optional[Sequence[PatternKeyframes]] = None,
               rotate_to: Optional[Direction] = None, rate: Optional[float] = None, loop: Optional[bool] = None,
               axis: Optional[Direction] = None, ring_deg: Optional[float] = None,
               speed_pins_s: Optional[float] = None, sense: Optional[Sense] = None,
               stepping: Optional[Stepping] = None, frame: Optional[Frame] = None,
               level: Optional[float] = None, current_a: Optional[float] = None,
               force_n: Optional[float] = None, gain: Optional[float] = None, start_at_ns: Optional[int] = None,
               delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
               fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
               fade_level: Optional[float] = None, waveform: Optional[PatternWaveform] = None,
               frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
               duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
               on_close: Optional[OnClose] = None, slot: Optional[str] = None, priority: Optional[int] = None,
               if_limited: Optional[IfLimited] = None) -> Admission:
        """Changes a playing effect and renews its lease.

        effect: The number of an effect, from its admission; 1 to 4294967295
        direction: Where the pins push out
        pattern: The name of a pattern, or keyframes instead
        keyframes: Where and how strongly, at points in time; t_ms never falls
        rotate_to: Patterns face front; this turns the front there by the shortest way
        rate: So many times as fast; 0.1 to 10
        loop: Begins again at its end
        axis: The axis of the circle
        ring_deg: Angle between the axis and the circle; 90 is the equator; 0 to 180
        speed_pins_s: Steps a second; a step is the pitch of the pins; 0.1 to 100
        sense: As seen from outside along the axis; ccw, cw
        stepping: From pin to pin, or gliding; pin, smooth
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = self.call("effect.update", effect=effect, direction=direction, pattern=pattern,
            keyframes=keyframes, rotate_to=rotate_to, rate=rate, loop=loop, axis=axis, ring_deg=ring_deg,
            speed_pins_s=speed_pins_s, sense=sense, stepping=stepping, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)
        return result

    def vibrate(self, direction: Optional[Direction] = None, *, frame: Optional[Frame] = None,
                level: Optional[float] = None, current_a: Optional[float] = None,
                force_n: Optional[float] = None, gain: Optional[float] = None,
                start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
                attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
                attack_level: Optional[float] = None, fade_level: Optional[float] = None,
                waveform: Optional[PatternWaveform] = None, frequency_hz: Optional[float] = None,
                on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
                lease_ms: Optional[float] = None, on_close: Optional[OnClose] = None,
                slot: Optional[str] = None, priority: Optional[int] = None,
                if_limited: Optional[IfLimited] = None) -> Admission:
        """A push with a waveform.

        direction: Where the pins push out
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = self.call("effect.vibrate", direction=direction, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)
        return result

    def events_history(self, *, since: Optional[str] = None, types: Optional[Sequence[str]] = None,
                       trips: Optional[bool] = None, limit: Optional[int] = None) -> History:
        """Past events, including those before the last start.

        since: Not before this time, RFC 3339
        types: Names of events; default all
        trips
        limit: The newest so many; 1 to 1000
        """
        result: History = self.call("events.history", since=since, types=types, trips=trips, limit=limit)
        return result

    def orientation_recenter(self, *, azimuth_deg: Optional[float] = None) -> Recentered:
        """Sets the azimuth of the ball's front.

        azimuth_deg: Anticlockwise seen from above; -360 to 360
        """
        result: Recentered = self.call("orientation.recenter", azimuth_deg=azimuth_deg)
        return result

    def orientation_set(self, quaternion: StatusOrientationQuaternion) -> Done:
        """Sets the orientation measured by an external sensor.

        quaternion: Device to world, of length 1
        """
        result: Done = self.call("orientation.set", quaternion=quaternion)
        return result

    def output_set_gain(self, gain: float) -> Gain:
        """Gain applied to all effects; persistent.

        gain: Multiplies the strength; 0 to 1
        """
        result: Gain = self.call("output.set_gain", gain=gain)
        return result

    def pattern_get(self, name: str) -> Pattern:
        """One named pattern with its key frames.

        name: Of a pattern: vendor/name, or that of a shipped one
        """
        result: Pattern = self.call("pattern.get", name=name)
        return result

    def pattern_list(self) -> Patterns:
        """Lists the named patterns."""
        result: Patterns = self.call("pattern.list")
        return result

    def pattern_put(self, name: str, keyframes: Sequence[PatternKeyframes], *,
                    description: Optional[str] = None, waveform: Optional[PatternWaveform] = None,
                    frequency_hz: Optional[float] = None,
                    on_fraction: Optional[float] = None) -> PatternSummary:
        """Stores a pattern under vendor/name.

        name: Of a pattern: vendor/name, or that of a shipped one
        keyframes: Where and how strongly, at points in time; t_ms never falls
        description: One sentence for whoever chooses a pattern
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        """
        result: PatternSummary = self.call("pattern.put", name=name, keyframes=keyframes,
            description=description, waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction)
        return result

    def pattern_remove(self, name: str) -> Done:
        """Removes a stored pattern.

        name: Of a pattern: vendor/name, or that of a shipped one
        """
        result: Done = self.call("pattern.remove", name=name)
        return result

    def ping(self) -> Ping:
        """The device time."""
        result: Ping = self.call("ping")
        return result

    def sim_set(self, *, orientation: Optional[StatusOrientationQuaternion] = None,
                ambient_c: Optional[float] = None, fault: Optional[Fault] = None,
                errors: Optional[Sequence[SimulatedWorldErrors]] = None) -> SimulatedWorld:
        """Sets orientation, ambient temperature and faults of the simulation.

        orientation: Device to world, of length 1
        ambient_c: Temperature of the simulated room; -20 to 60
        fault: Replaces all simulated faults; {} clears them
        errors: Replaces all errors of measurement and of the ball; [] ends them
        """
        result: SimulatedWorld = self.call("sim.set", orientation=orientation, ambient_c=ambient_c, fault=fault,
            errors=errors)
        return result

    def sim_truth(self) -> SimulatedTruth:
        """True state of the simulated ball."""
        result: SimulatedTruth = self.call("sim.truth")
        return result

    def telemetry_history(self, *, seconds: Optional[float] = None) -> TelemetryHistory:
        """Temperatures and currents of the last minutes.

        seconds: 1 to 600
        """
        result: TelemetryHistory = self.call("telemetry.history", seconds=seconds)
        return result

    def thermal_forecast(self, *, current_a: Optional[float] = None, direction: Optional[Direction] = None,
                         method: Optional[Method] = None, params: Optional[Mapping[str, Any]] = None,
                         effect: Optional[int] = None) -> Forecast:
        """How long a current or an effect can flow.

        current_a: Strength as a current; at most limits.current_a; at least 0
        direction: Where the pins push out
        method: A method that plays; effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play
        params: The parameters of that method
        effect: The number of an effect, from its admission; 1 to 4294967295
        """
        result: Forecast = self.call("thermal.forecast", current_a=current_a, direction=direction,
            method=method, params=params, effect=effect)
        return result


class AsyncMethods:
    """The same as coroutines."""

    async def call(self, method: str, /, **params: Any) -> Any:
        raise NotImplementedError

    async def connection_list(self) -> Connections:
        """The connections, with their start times and effects."""
        result: Connections = await self.call("connection.list")
        return result

    async def arm(self) -> State:
        """Arms the ball once the cause of the stop no longer exists."""
        result: State = await self.call("device.arm")
        return result

    async def claim(self, *, lease_ms: Optional[float] = None) -> Claim:
        """Exclusive use of the ball until release, end of the connection, or expiry of the lease.

        lease_ms: Ends after it unless renewed; 100 to 10000
        """
        result: Claim = await self.call("device.claim", lease_ms=lease_ms)
        return result

    async def describe(self) -> Description:
        """The ball: pins, coils, limits, calibration, identity."""
        result: Description = await self.call("device.describe")
        return result

    async def emergency_stop(self) -> State:
        """Coils off at the next tick, latched until armed."""
        result: State = await self.call("device.emergency_stop")
        return result

    async def enter_boot_loader(self) -> State:
        """Restarts the board in its boot loader, for a firmware update; rejected while armed."""
        result: State = await self.call("device.enter_boot_loader")
        return result

    async def list(self) -> Devices:
        """USB and HID devices: which are used, and why the others are not."""
        result: Devices = await self.call("device.list")
        return result

    async def release(self) -> Done:
        """Releases the claim."""
        result: Done = await self.call("device.release")
        return result

    async def status(self) -> Status:
        """State of the ball: temperatures, currents, limits, effects."""
        result: Status = await self.call("device.status")
        return result

    async def circle(self, axis: Optional[Direction] = None, *, ring_deg: Optional[float] = None,
                     speed_pins_s: Optional[float] = None, sense: Optional[Sense] = None,
                     stepping: Optional[Stepping] = None, frame: Optional[Frame] = None,
                     level: Optional[float] = None, current_a: Optional[float] = None,
                     force_n: Optional[float] = None, gain: Optional[float] = None,
                     start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
                     attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
                     attack_level: Optional[float] = None, fade_level: Optional[float] = None,
                     waveform: Optional[PatternWaveform] = None, frequency_hz: Optional[float] = None,
                     on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
                     lease_ms: Optional[float] = None, on_close: Optional[OnClose] = None,
                     slot: Optional[str] = None, priority: Optional[int] = None,
                     if_limited: Optional[IfLimited] = None) -> Admission:
        """The field rotates about an axis, from pin to pin.

        axis: The axis of the circle
        ring_deg: Angle between the axis and the circle; 90 is the equator; 0 to 180
        speed_pins_s: Steps a second; a step is the pitch of the pins; 0.1 to 100
        sense: As seen from outside along the axis; ccw, cw
        stepping: From pin to pin, or gliding; pin, smooth
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = await self.call("effect.circle", axis=axis, ring_deg=ring_deg,
            speed_pins_s=speed_pins_s, sense=sense, stepping=stepping, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)
        return result

    async def hold(self, direction: Direction, *, frame: Optional[Frame] = None, level: Optional[float] = None,
                   current_a: Optional[float] = None, force_n: Optional[float] = None,
                   gain: Optional[float] = None, start_at_ns: Optional[int] = None,
                   delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
                   fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
                   fade_level: Optional[float] = None, waveform: Optional[PatternWaveform] = None,
                   frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
                   duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
                   on_close: Optional[OnClose] = None, slot: Optional[str] = None,
                   priority: Optional[int] = None, if_limited: Optional[IfLimited] = None) -> Admission:
        """A push that lasts as long as it is renewed.

        direction: Where the pins push out
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = await self.call("effect.hold", direction=direction, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)
        return result

    async def latency(self) -> Latency:
        """How long effects took from their request to the board."""
        result: Latency = await self.call("effect.latency")
        return result

    async def play(self, pattern: Optional[str] = None, *,
                   keyframes: Optional[Sequence[PatternKeyframes]] = None,
                   rotate_to: Optional[Direction] = None, rate: Optional[float] = None,
                   loop: Optional[bool] = None, frame: Optional[Frame] = None, level: Optional[float] = None,
                   current_a: Optional[float] = None, force_n: Optional[float] = None,
                   gain: Optional[float] = None, start_at_ns: Optional[int] = None,
                   delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
                   fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
                   fade_level: Optional[float] = None, waveform: Optional[PatternWaveform] = None,
                   frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
                   duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
                   on_close: Optional[OnClose] = None, slot: Optional[str] = None,
                   priority: Optional[int] = None, if_limited: Optional[IfLimited] = None) -> Admission:
        """Plays key frames, of a named pattern or its own.

        pattern: The name of a pattern, or keyframes instead
        keyframes: Where and how strongly, at points in time; t_ms never falls
        rotate_to: Patterns face front; this turns the front there by the shortest way
        rate: So many times as fast; 0.1 to 10
        loop: Begins again at its end
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = await self.call("effect.play", pattern=pattern, keyframes=keyframes,
            rotate_to=rotate_to, rate=rate, loop=loop, frame=frame, level=level, current_a=current_a,
            force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms, attack_ms=attack_ms,
            fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level, waveform=waveform,
            frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms, lease_ms=lease_ms,
            on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)
        return result

    async def preview(self, method: Method, params: Mapping[str, Any]) -> Preview:
        """Computes currents and temperatures of an effect without starting it.

        method: A method that plays; effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play
        params: The parameters of that method
        """
        result: Preview = await self.call("effect.preview", method=method, params=params)
        return result

    async def pulse(self, direction: Direction, *, frame: Optional[Frame] = None, level: Optional[float] = None,
                    current_a: Optional[float] = None, force_n: Optional[float] = None,
                    gain: Optional[float] = None, start_at_ns: Optional[int] = None,
                    delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
                    fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
                    fade_level: Optional[float] = None, waveform: Optional[PatternWaveform] = None,
                    frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
                    duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
                    on_close: Optional[OnClose] = None, slot: Optional[str] = None,
                    priority: Optional[int] = None, if_limited: Optional[IfLimited] = None) -> Admission:
        """One push towards a direction.

        direction: Where the pins push out
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = await self.call("effect.pulse", direction=direction, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)
        return result

    async def stop(self, *, effect: Optional[int] = None, slot: Optional[str] = None) -> Stopped:
        """Ends one of the connection's own effects.

        effect: The number of an effect, from its admission; 1 to 4294967295
        slot: The connection's own name for an effect
        """
        result: Stopped = await self.call("effect.stop", effect=effect, slot=slot)
        return result

    async def stop_all(self, *, scope: Optional[Scope] = None) -> Stopped:
        """Ends all effects of the connection, or of all connections.

        scope: "all" for effects of others too; mine, all
        """
        result: Stopped = await self.call("effect.stop_all", scope=scope)
        return result

    async def update(self, *, effect: Optional[int] = None, direction: Optional[Direction] = None,
                     pattern: Optional[str] = None, keyframes: Optional[Sequence[PatternKeyframes]] = None,
                     rotate_to: Optional[Direction] = None, rate: Optional[float] = None,
                     loop: Optional[bool] = None, axis: Optional[Direction] = None,
                     ring_deg: Optional[float] = None, speed_pins_s: Optional[float] = None,
                     sense: Optional[Sense] = None, stepping: Optional[Stepping] = None,
                     frame: Optional[Frame] = None, level: Optional[float] = None,
                     current_a: Optional[float] = None, force_n: Optional[float] = None,
                     gain: Optional[float] = None, start_at_ns: Optional[int] = None,
                     delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
                     fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
                     fade_level: Optional[float] = None, waveform: Optional[PatternWaveform] = None,
                     frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
                     duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
                     on_close: Optional[OnClose] = None, slot: Optional[str] = None,
                     priority: Optional[int] = None, if_limited: Optional[IfLimited] = None) -> Admission:
        """Changes a playing effect and renews its lease.

        effect: The number of an effect, from its admission; 1 to 4294967295
        direction: Where the pins push out
        pattern: The name of a pattern, or keyframes instead
        keyframes: Where and how strongly, at points in time; t_ms never falls
        rotate_to: Patterns face front; this turns the front there by the shortest way
        rate: So many times as fast; 0.1 to 10
        loop: Begins again at its end
        axis: The axis of the circle
        ring_deg: Angle between the axis and the circle; 90 is the equator; 0 to 180
        speed_pins_s: Steps a second; a step is the pitch of the pins; 0.1 to 100
        sense: As seen from outside along the axis; ccw, cw
        stepping: From pin to pin, or gliding; pin, smooth
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = await self.call("effect.update", effect=effect, direction=direction,
            pattern=pattern, keyframes=keyframes, rotate_to=rotate_to, rate=rate, loop=loop, axis=axis,
            ring_deg=ring_deg, speed_pins_s=speed_pins_s, sense=sense, stepping=stepping, frame=frame,
            level=level, current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns,
            delay_ms=delay_ms, attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level,
            fade_level=fade_level, waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction,
            duration_ms=duration_ms, lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority,
            if_limited=if_limited)
        return result

    async def vibrate(self, direction: Optional[Direction] = None, *, frame: Optional[Frame] = None,
                      level: Optional[float] = None, current_a: Optional[float] = None,
                      force_n: Optional[float] = None, gain: Optional[float] = None,
                      start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
                      attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
                      attack_level: Optional[float] = None, fade_level: Optional[float] = None,
                      waveform: Optional[PatternWaveform] = None, frequency_hz: Optional[float] = None,
                      on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
                      lease_ms: Optional[float] = None, on_close: Optional[OnClose] = None,
                      slot: Optional[str] = None, priority: Optional[int] = None,
                      if_limited: Optional[IfLimited] = None) -> Admission:
        """A push with a waveform.

        direction: Where the pins push out
        frame: The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A); device, world,
            coil
        level: Strength as a part of limits.current_a; 0 to 1
        current_a: Strength as a current; at most limits.current_a; at least 0
        force_n: Strength as the force on the pin that is pointed at; at least 0
        gain: Multiplies the strength; 0 to 1
        start_at_ns: Device time of the onset; at least 0
        delay_ms: From now to the onset; 0 to 10000
        attack_ms: Linear rise, inside the duration; 0 to 10000
        fade_ms: Linear fall, inside the duration; not with a lease; 0 to 10000
        attack_level: Where the rise begins, as a part of the strength; 0 to 1
        fade_level: Where the fall ends, as a part of the strength; 0 to 1
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        duration_ms: The effect ends after it. Never together with lease_ms; 1 to 10000
        lease_ms: Ends after it unless renewed; 100 to 10000
        on_close: "finish" lets an effect of up to 2000 ms play out after the connection ended; stop, finish
        slot: The connection's own name for an effect
        priority: Only effects of the highest active priority are output; 8 and 9 need the role operate; 0
            to 9
        if_limited: "refuse": an error instead of a reduced effect; reduce, refuse
        """
        result: Admission = await self.call("effect.vibrate", direction=direction, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)
        return result

    async def events_history(self, *, since: Optional[str] = None, types: Optional[Sequence[str]] = None,
                             trips: Optional[bool] = None, limit: Optional[int] = None) -> History:
        """Past events, including those before the last start.

        since: Not before this time, RFC 3339
        types: Names of events; default all
        trips
        limit: The newest so many; 1 to 1000
        """
        result: History = await self.call("events.history", since=since, types=types, trips=trips, limit=limit)
        return result

    async def orientation_recenter(self, *, azimuth_deg: Optional[float] = None) -> Recentered:
        """Sets the azimuth of the ball's front.

        azimuth_deg: Anticlockwise seen from above; -360 to 360
        """
        result: Recentered = await self.call("orientation.recenter", azimuth_deg=azimuth_deg)
        return result

    async def orientation_set(self, quaternion: StatusOrientationQuaternion) -> Done:
        """Sets the orientation measured by an external sensor.

        quaternion: Device to world, of length 1
        """
        result: Done = await self.call("orientation.set", quaternion=quaternion)
        return result

    async def output_set_gain(self, gain: float) -> Gain:
        """Gain applied to all effects; persistent.

        gain: Multiplies the strength; 0 to 1
        """
        result: Gain = await self.call("output.set_gain", gain=gain)
        return result

    async def pattern_get(self, name: str) -> Pattern:
        """One named pattern with its key frames.

        name: Of a pattern: vendor/name, or that of a shipped one
        """
        result: Pattern = await self.call("pattern.get", name=name)
        return result

    async def pattern_list(self) -> Patterns:
        """Lists the named patterns."""
        result: Patterns = await self.call("pattern.list")
        return result

    async def pattern_put(self, name: str, keyframes: Sequence[PatternKeyframes], *,
                          description: Optional[str] = None, waveform: Optional[PatternWaveform] = None,
                          frequency_hz: Optional[float] = None,
                          on_fraction: Optional[float] = None) -> PatternSummary:
        """Stores a pattern under vendor/name.

        name: Of a pattern: vendor/name, or that of a shipped one
        keyframes: Where and how strongly, at points in time; t_ms never falls
        description: One sentence for whoever chooses a pattern
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        """
        result: PatternSummary = await self.call("pattern.put", name=name, keyframes=keyframes,
            description=description, waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction)
        return result

    async def pattern_remove(self, name: str) -> Done:
        """Removes a stored pattern.

        name: Of a pattern: vendor/name, or that of a shipped one
        """
        result: Done = await self.call("pattern.remove", name=name)
        return result

    async def ping(self) -> Ping:
        """The device time."""
        result: Ping = await self.call("ping")
        return result

    async def sim_set(self, *, orientation: Optional[StatusOrientationQuaternion] = None,
                      ambient_c: Optional[float] = None, fault: Optional[Fault] = None,
                      errors: Optional[Sequence[SimulatedWorldErrors]] = None) -> SimulatedWorld:
        """Sets orientation, ambient temperature and faults of the simulation.

        orientation: Device to world, of length 1
        ambient_c: Temperature of the simulated room; -20 to 60
        fault: Replaces all simulated faults; {} clears them
        errors: Replaces all errors of measurement and of the ball; [] ends them
        """
        result: SimulatedWorld = await self.call("sim.set", orientation=orientation, ambient_c=ambient_c,
            fault=fault, errors=errors)
        return result

    async def sim_truth(self) -> SimulatedTruth:
        """True state of the simulated ball."""
        result: SimulatedTruth = await self.call("sim.truth")
        return result

    async def telemetry_history(self, *, seconds: Optional[float] = None) -> TelemetryHistory:
        """Temperatures and currents of the last minutes.

        seconds: 1 to 600
        """
        result: TelemetryHistory = await self.call("telemetry.history", seconds=seconds)
        return result

    async def thermal_forecast(self, *, current_a: Optional[float] = None,
                               direction: Optional[Direction] = None, method: Optional[Method] = None,
                               params: Optional[Mapping[str, Any]] = None,
                               effect: Optional[int] = None) -> Forecast:
        """How long a current or an effect can flow.

        current_a: Strength as a current; at most limits.current_a; at least 0
        direction: Where the pins push out
        method: A method that plays; effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play
        params: The parameters of that method
        effect: The number of an effect, from its admission; 1 to 4294967295
        """
        result: Forecast = await self.call("thermal.forecast", current_a=current_a, direction=direction,
            method=method, params=params, effect=effect)
        return result
