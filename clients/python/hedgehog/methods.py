# SPDX-License-Identifier: MIT
# Written by generate.py from protocol/schema/openrpc.json.
"""The daemon's methods. Parameters that are None are left out; protocol/README.md has all of them at length."""

from typing import Any, List, Mapping, Optional, Sequence, Union

#: "left", [0, 1, 0], {"azimuth_deg": 90} or {"pin": 34}: where the pins push out.
Direction = Union[str, Sequence[float], Mapping[str, Any]]


class Methods:
    """Methods that wait for their response."""

    def call(self, method: str, /, **params: Any) -> Any:
        raise NotImplementedError

    def connection_list(self) -> Any:
        """Who is connected, since when, and what they play."""
        return self.call("connection.list")

    def arm(self) -> Any:
        """Lets the coils be driven again, when the cause of the stop is gone."""
        return self.call("device.arm")

    def claim(self, *, lease_ms: Optional[float] = None) -> Any:
        """Only this connection plays until it releases, ends, or is silent.

        lease_ms: Ends after it unless renewed; 100 to 10000
        """
        return self.call("device.claim", lease_ms=lease_ms)

    def describe(self) -> Any:
        """The ball: pins, coils, limits, calibration, identity."""
        return self.call("device.describe")

    def emergency_stop(self) -> Any:
        """Coils off at the next tick, latched until armed."""
        return self.call("device.emergency_stop")

    def enter_boot_loader(self) -> Any:
        """The board goes into its boot loader and waits for new firmware; not while it is armed."""
        return self.call("device.enter_boot_loader")

    def list(self) -> Any:
        """USB and HID devices: which are used, and why the others are not."""
        return self.call("device.list")

    def release(self) -> Any:
        """Gives a claim back."""
        return self.call("device.release")

    def status(self) -> Any:
        """Everything that can be known of the ball now."""
        return self.call("device.status")

    def circle(self, axis: Optional[Direction] = None, *, ring_deg: Optional[float] = None,
               speed_pins_s: Optional[float] = None, sense: Optional[str] = None,
               stepping: Optional[str] = None, frame: Optional[str] = None, level: Optional[float] = None,
               current_a: Optional[float] = None, force_n: Optional[float] = None, gain: Optional[float] = None,
               start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
               attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
               attack_level: Optional[float] = None, fade_level: Optional[float] = None,
               waveform: Optional[str] = None, frequency_hz: Optional[float] = None,
               on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
               lease_ms: Optional[float] = None, on_close: Optional[str] = None, slot: Optional[str] = None,
               priority: Optional[int] = None, if_limited: Optional[str] = None) -> Any:
        """The field walks round an axis, from pin to pin.

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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return self.call("effect.circle", axis=axis, ring_deg=ring_deg, speed_pins_s=speed_pins_s, sense=sense,
            stepping=stepping, frame=frame, level=level, current_a=current_a, force_n=force_n, gain=gain,
            start_at_ns=start_at_ns, delay_ms=delay_ms, attack_ms=attack_ms, fade_ms=fade_ms,
            attack_level=attack_level, fade_level=fade_level, waveform=waveform, frequency_hz=frequency_hz,
            on_fraction=on_fraction, duration_ms=duration_ms, lease_ms=lease_ms, on_close=on_close, slot=slot,
            priority=priority, if_limited=if_limited)

    def hold(self, direction: Direction, *, frame: Optional[str] = None, level: Optional[float] = None,
             current_a: Optional[float] = None, force_n: Optional[float] = None, gain: Optional[float] = None,
             start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
             attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
             attack_level: Optional[float] = None, fade_level: Optional[float] = None,
             waveform: Optional[str] = None, frequency_hz: Optional[float] = None,
             on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
             lease_ms: Optional[float] = None, on_close: Optional[str] = None, slot: Optional[str] = None,
             priority: Optional[int] = None, if_limited: Optional[str] = None) -> Any:
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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return self.call("effect.hold", direction=direction, frame=frame, level=level, current_a=current_a,
            force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms, attack_ms=attack_ms,
            fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level, waveform=waveform,
            frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms, lease_ms=lease_ms,
            on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)

    def play(self, pattern: Optional[str] = None, *, keyframes: Optional[List[Mapping[str, Any]]] = None,
             rotate_to: Optional[Direction] = None, rate: Optional[float] = None, loop: Optional[bool] = None,
             frame: Optional[str] = None, level: Optional[float] = None, current_a: Optional[float] = None,
             force_n: Optional[float] = None, gain: Optional[float] = None, start_at_ns: Optional[int] = None,
             delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
             fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
             fade_level: Optional[float] = None, waveform: Optional[str] = None,
             frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
             duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
             on_close: Optional[str] = None, slot: Optional[str] = None, priority: Optional[int] = None,
             if_limited: Optional[str] = None) -> Any:
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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return self.call("effect.play", pattern=pattern, keyframes=keyframes, rotate_to=rotate_to, rate=rate,
            loop=loop, frame=frame, level=level, current_a=current_a, force_n=force_n, gain=gain,
            start_at_ns=start_at_ns, delay_ms=delay_ms, attack_ms=attack_ms, fade_ms=fade_ms,
            attack_level=attack_level, fade_level=fade_level, waveform=waveform, frequency_hz=frequency_hz,
            on_fraction=on_fraction, duration_ms=duration_ms, lease_ms=lease_ms, on_close=on_close, slot=slot,
            priority=priority, if_limited=if_limited)

    def preview(self, method: str, params: Mapping[str, Any]) -> Any:
        """What an effect would do, without doing it.

        method: A method that plays; effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play
        params: The parameters of that method
        """
        return self.call("effect.preview", method=method, params=params)

    def pulse(self, direction: Direction, *, frame: Optional[str] = None, level: Optional[float] = None,
              current_a: Optional[float] = None, force_n: Optional[float] = None, gain: Optional[float] = None,
              start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
              attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
              attack_level: Optional[float] = None, fade_level: Optional[float] = None,
              waveform: Optional[str] = None, frequency_hz: Optional[float] = None,
              on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
              lease_ms: Optional[float] = None, on_close: Optional[str] = None, slot: Optional[str] = None,
              priority: Optional[int] = None, if_limited: Optional[str] = None) -> Any:
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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return self.call("effect.pulse", direction=direction, frame=frame, level=level, current_a=current_a,
            force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms, attack_ms=attack_ms,
            fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level, waveform=waveform,
            frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms, lease_ms=lease_ms,
            on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)

    def stop(self, *, effect: Optional[int] = None, slot: Optional[str] = None) -> Any:
        """Ends one of the connection's own effects.

        effect: The number of an effect, from its admission; 1 to 4294967295
        slot: The connection's own name for an effect
        """
        return self.call("effect.stop", effect=effect, slot=slot)

    def stop_all(self, *, scope: Optional[str] = None) -> Any:
        """Ends all effects of the connection, or of everybody.

        scope: "all" for effects of others too; mine, all
        """
        return self.call("effect.stop_all", scope=scope)

    def update(self, *, effect: Optional[int] = None, direction: Optional[Direction] = None,
               pattern: Optional[str] = None, keyframes: Optional[List[Mapping[str, Any]]] = None,
               rotate_to: Optional[Direction] = None, rate: Optional[float] = None, loop: Optional[bool] = None,
               axis: Optional[Direction] = None, ring_deg: Optional[float] = None,
               speed_pins_s: Optional[float] = None, sense: Optional[str] = None,
               stepping: Optional[str] = None, frame: Optional[str] = None, level: Optional[float] = None,
               current_a: Optional[float] = None, force_n: Optional[float] = None, gain: Optional[float] = None,
               start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
               attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
               attack_level: Optional[float] = None, fade_level: Optional[float] = None,
               waveform: Optional[str] = None, frequency_hz: Optional[float] = None,
               on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
               lease_ms: Optional[float] = None, on_close: Optional[str] = None, slot: Optional[str] = None,
               priority: Optional[int] = None, if_limited: Optional[str] = None) -> Any:
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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return self.call("effect.update", effect=effect, direction=direction, pattern=pattern,
            keyframes=keyframes, rotate_to=rotate_to, rate=rate, loop=loop, axis=axis, ring_deg=ring_deg,
            speed_pins_s=speed_pins_s, sense=sense, stepping=stepping, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)

    def vibrate(self, direction: Optional[Direction] = None, *, frame: Optional[str] = None,
                level: Optional[float] = None, current_a: Optional[float] = None,
                force_n: Optional[float] = None, gain: Optional[float] = None,
                start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
                attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
                attack_level: Optional[float] = None, fade_level: Optional[float] = None,
                waveform: Optional[str] = None, frequency_hz: Optional[float] = None,
                on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
                lease_ms: Optional[float] = None, on_close: Optional[str] = None, slot: Optional[str] = None,
                priority: Optional[int] = None, if_limited: Optional[str] = None) -> Any:
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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return self.call("effect.vibrate", direction=direction, frame=frame, level=level, current_a=current_a,
            force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms, attack_ms=attack_ms,
            fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level, waveform=waveform,
            frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms, lease_ms=lease_ms,
            on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)

    def events_history(self, *, since: Optional[str] = None, types: Optional[List[str]] = None,
                       trips: Optional[bool] = None, limit: Optional[int] = None) -> Any:
        """What has happened, also before the last start.

        since: Not before this time, RFC 3339
        types: Names of events; default all
        trips
        limit: The newest so many; 1 to 1000
        """
        return self.call("events.history", since=since, types=types, trips=trips, limit=limit)

    def orientation_recenter(self, *, azimuth_deg: Optional[float] = None) -> Any:
        """The front of the ball points at this azimuth now.

        azimuth_deg: Anticlockwise seen from above; -360 to 360
        """
        return self.call("orientation.recenter", azimuth_deg=azimuth_deg)

    def orientation_set(self, quaternion: Mapping[str, Any]) -> Any:
        """Feeds the orientation from outside.

        quaternion: Device to world, of length 1
        """
        return self.call("orientation.set", quaternion=quaternion)

    def output_set_gain(self, gain: float) -> Any:
        """The owner's comfort setting for everything, stored.

        gain: Multiplies the strength; 0 to 1
        """
        return self.call("output.set_gain", gain=gain)

    def pattern_get(self, name: str) -> Any:
        """One named pattern with its key frames.

        name: Of a pattern: vendor/name, or that of a shipped one
        """
        return self.call("pattern.get", name=name)

    def pattern_list(self) -> Any:
        """The named patterns there are."""
        return self.call("pattern.list")

    def pattern_put(self, name: str, keyframes: List[Mapping[str, Any]], *, description: Optional[str] = None,
                    waveform: Optional[str] = None, frequency_hz: Optional[float] = None,
                    on_fraction: Optional[float] = None) -> Any:
        """Keeps a pattern under vendor/name.

        name: Of a pattern: vendor/name, or that of a shipped one
        keyframes: Where and how strongly, at points in time; t_ms never falls
        description: One sentence for whoever chooses a pattern
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        """
        return self.call("pattern.put", name=name, keyframes=keyframes, description=description,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction)

    def pattern_remove(self, name: str) -> Any:
        """Forgets a pattern that was put.

        name: Of a pattern: vendor/name, or that of a shipped one
        """
        return self.call("pattern.remove", name=name)

    def ping(self) -> Any:
        """The device time."""
        return self.call("ping")

    def sim_set(self, *, orientation: Optional[Mapping[str, Any]] = None, ambient_c: Optional[float] = None,
                fault: Optional[Mapping[str, Any]] = None,
                errors: Optional[List[Mapping[str, Any]]] = None) -> Any:
        """Changes the simulated world.

        orientation: Device to world, of length 1
        ambient_c: Temperature of the simulated room; -20 to 60
        fault: Replaces all simulated faults; {} mends the ball
        errors: Replaces all errors of measurement and of the ball; [] ends them
        """
        return self.call("sim.set", orientation=orientation, ambient_c=ambient_c, fault=fault, errors=errors)

    def sim_truth(self) -> Any:
        """The simulated ball as it really is."""
        return self.call("sim.truth")

    def telemetry_history(self, *, seconds: Optional[float] = None) -> Any:
        """Temperatures and currents of the last minutes.

        seconds: 1 to 600
        """
        return self.call("telemetry.history", seconds=seconds)

    def thermal_forecast(self, *, current_a: Optional[float] = None, direction: Optional[Direction] = None,
                         method: Optional[str] = None, params: Optional[Mapping[str, Any]] = None,
                         effect: Optional[int] = None) -> Any:
        """How long a current or an effect can flow.

        current_a: Strength as a current; at most limits.current_a; at least 0
        direction: Where the pins push out
        method: A method that plays; effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play
        params: The parameters of that method
        effect: The number of an effect, from its admission; 1 to 4294967295
        """
        return self.call("thermal.forecast", current_a=current_a, direction=direction, method=method,
            params=params, effect=effect)


class AsyncMethods:
    """The same as coroutines."""

    async def call(self, method: str, /, **params: Any) -> Any:
        raise NotImplementedError

    async def connection_list(self) -> Any:
        """Who is connected, since when, and what they play."""
        return await self.call("connection.list")

    async def arm(self) -> Any:
        """Lets the coils be driven again, when the cause of the stop is gone."""
        return await self.call("device.arm")

    async def claim(self, *, lease_ms: Optional[float] = None) -> Any:
        """Only this connection plays until it releases, ends, or is silent.

        lease_ms: Ends after it unless renewed; 100 to 10000
        """
        return await self.call("device.claim", lease_ms=lease_ms)

    async def describe(self) -> Any:
        """The ball: pins, coils, limits, calibration, identity."""
        return await self.call("device.describe")

    async def emergency_stop(self) -> Any:
        """Coils off at the next tick, latched until armed."""
        return await self.call("device.emergency_stop")

    async def enter_boot_loader(self) -> Any:
        """The board goes into its boot loader and waits for new firmware; not while it is armed."""
        return await self.call("device.enter_boot_loader")

    async def list(self) -> Any:
        """USB and HID devices: which are used, and why the others are not."""
        return await self.call("device.list")

    async def release(self) -> Any:
        """Gives a claim back."""
        return await self.call("device.release")

    async def status(self) -> Any:
        """Everything that can be known of the ball now."""
        return await self.call("device.status")

    async def circle(self, axis: Optional[Direction] = None, *, ring_deg: Optional[float] = None,
                     speed_pins_s: Optional[float] = None, sense: Optional[str] = None,
                     stepping: Optional[str] = None, frame: Optional[str] = None, level: Optional[float] = None,
                     current_a: Optional[float] = None, force_n: Optional[float] = None,
                     gain: Optional[float] = None, start_at_ns: Optional[int] = None,
                     delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
                     fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
                     fade_level: Optional[float] = None, waveform: Optional[str] = None,
                     frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
                     duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
                     on_close: Optional[str] = None, slot: Optional[str] = None, priority: Optional[int] = None,
                     if_limited: Optional[str] = None) -> Any:
        """The field walks round an axis, from pin to pin.

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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return await self.call("effect.circle", axis=axis, ring_deg=ring_deg, speed_pins_s=speed_pins_s,
            sense=sense, stepping=stepping, frame=frame, level=level, current_a=current_a, force_n=force_n,
            gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms, attack_ms=attack_ms, fade_ms=fade_ms,
            attack_level=attack_level, fade_level=fade_level, waveform=waveform, frequency_hz=frequency_hz,
            on_fraction=on_fraction, duration_ms=duration_ms, lease_ms=lease_ms, on_close=on_close, slot=slot,
            priority=priority, if_limited=if_limited)

    async def hold(self, direction: Direction, *, frame: Optional[str] = None, level: Optional[float] = None,
                   current_a: Optional[float] = None, force_n: Optional[float] = None,
                   gain: Optional[float] = None, start_at_ns: Optional[int] = None,
                   delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
                   fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
                   fade_level: Optional[float] = None, waveform: Optional[str] = None,
                   frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
                   duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
                   on_close: Optional[str] = None, slot: Optional[str] = None, priority: Optional[int] = None,
                   if_limited: Optional[str] = None) -> Any:
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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return await self.call("effect.hold", direction=direction, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)

    async def play(self, pattern: Optional[str] = None, *, keyframes: Optional[List[Mapping[str, Any]]] = None,
                   rotate_to: Optional[Direction] = None, rate: Optional[float] = None,
                   loop: Optional[bool] = None, frame: Optional[str] = None, level: Optional[float] = None,
                   current_a: Optional[float] = None, force_n: Optional[float] = None,
                   gain: Optional[float] = None, start_at_ns: Optional[int] = None,
                   delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
                   fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
                   fade_level: Optional[float] = None, waveform: Optional[str] = None,
                   frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
                   duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
                   on_close: Optional[str] = None, slot: Optional[str] = None, priority: Optional[int] = None,
                   if_limited: Optional[str] = None) -> Any:
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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return await self.call("effect.play", pattern=pattern, keyframes=keyframes, rotate_to=rotate_to,
            rate=rate, loop=loop, frame=frame, level=level, current_a=current_a, force_n=force_n, gain=gain,
            start_at_ns=start_at_ns, delay_ms=delay_ms, attack_ms=attack_ms, fade_ms=fade_ms,
            attack_level=attack_level, fade_level=fade_level, waveform=waveform, frequency_hz=frequency_hz,
            on_fraction=on_fraction, duration_ms=duration_ms, lease_ms=lease_ms, on_close=on_close, slot=slot,
            priority=priority, if_limited=if_limited)

    async def preview(self, method: str, params: Mapping[str, Any]) -> Any:
        """What an effect would do, without doing it.

        method: A method that plays; effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play
        params: The parameters of that method
        """
        return await self.call("effect.preview", method=method, params=params)

    async def pulse(self, direction: Direction, *, frame: Optional[str] = None, level: Optional[float] = None,
                    current_a: Optional[float] = None, force_n: Optional[float] = None,
                    gain: Optional[float] = None, start_at_ns: Optional[int] = None,
                    delay_ms: Optional[float] = None, attack_ms: Optional[float] = None,
                    fade_ms: Optional[float] = None, attack_level: Optional[float] = None,
                    fade_level: Optional[float] = None, waveform: Optional[str] = None,
                    frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None,
                    duration_ms: Optional[float] = None, lease_ms: Optional[float] = None,
                    on_close: Optional[str] = None, slot: Optional[str] = None, priority: Optional[int] = None,
                    if_limited: Optional[str] = None) -> Any:
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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return await self.call("effect.pulse", direction=direction, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)

    async def stop(self, *, effect: Optional[int] = None, slot: Optional[str] = None) -> Any:
        """Ends one of the connection's own effects.

        effect: The number of an effect, from its admission; 1 to 4294967295
        slot: The connection's own name for an effect
        """
        return await self.call("effect.stop", effect=effect, slot=slot)

    async def stop_all(self, *, scope: Optional[str] = None) -> Any:
        """Ends all effects of the connection, or of everybody.

        scope: "all" for effects of others too; mine, all
        """
        return await self.call("effect.stop_all", scope=scope)

    async def update(self, *, effect: Optional[int] = None, direction: Optional[Direction] = None,
                     pattern: Optional[str] = None, keyframes: Optional[List[Mapping[str, Any]]] = None,
                     rotate_to: Optional[Direction] = None, rate: Optional[float] = None,
                     loop: Optional[bool] = None, axis: Optional[Direction] = None,
                     ring_deg: Optional[float] = None, speed_pins_s: Optional[float] = None,
                     sense: Optional[str] = None, stepping: Optional[str] = None, frame: Optional[str] = None,
                     level: Optional[float] = None, current_a: Optional[float] = None,
                     force_n: Optional[float] = None, gain: Optional[float] = None,
                     start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
                     attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
                     attack_level: Optional[float] = None, fade_level: Optional[float] = None,
                     waveform: Optional[str] = None, frequency_hz: Optional[float] = None,
                     on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
                     lease_ms: Optional[float] = None, on_close: Optional[str] = None,
                     slot: Optional[str] = None, priority: Optional[int] = None,
                     if_limited: Optional[str] = None) -> Any:
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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return await self.call("effect.update", effect=effect, direction=direction, pattern=pattern,
            keyframes=keyframes, rotate_to=rotate_to, rate=rate, loop=loop, axis=axis, ring_deg=ring_deg,
            speed_pins_s=speed_pins_s, sense=sense, stepping=stepping, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)

    async def vibrate(self, direction: Optional[Direction] = None, *, frame: Optional[str] = None,
                      level: Optional[float] = None, current_a: Optional[float] = None,
                      force_n: Optional[float] = None, gain: Optional[float] = None,
                      start_at_ns: Optional[int] = None, delay_ms: Optional[float] = None,
                      attack_ms: Optional[float] = None, fade_ms: Optional[float] = None,
                      attack_level: Optional[float] = None, fade_level: Optional[float] = None,
                      waveform: Optional[str] = None, frequency_hz: Optional[float] = None,
                      on_fraction: Optional[float] = None, duration_ms: Optional[float] = None,
                      lease_ms: Optional[float] = None, on_close: Optional[str] = None,
                      slot: Optional[str] = None, priority: Optional[int] = None,
                      if_limited: Optional[str] = None) -> Any:
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
        priority: Only the highest active one is felt; 8 and 9 need the role operate; 0 to 9
        if_limited: "refuse": an error instead of less than what was asked; reduce, refuse
        """
        return await self.call("effect.vibrate", direction=direction, frame=frame, level=level,
            current_a=current_a, force_n=force_n, gain=gain, start_at_ns=start_at_ns, delay_ms=delay_ms,
            attack_ms=attack_ms, fade_ms=fade_ms, attack_level=attack_level, fade_level=fade_level,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction, duration_ms=duration_ms,
            lease_ms=lease_ms, on_close=on_close, slot=slot, priority=priority, if_limited=if_limited)

    async def events_history(self, *, since: Optional[str] = None, types: Optional[List[str]] = None,
                             trips: Optional[bool] = None, limit: Optional[int] = None) -> Any:
        """What has happened, also before the last start.

        since: Not before this time, RFC 3339
        types: Names of events; default all
        trips
        limit: The newest so many; 1 to 1000
        """
        return await self.call("events.history", since=since, types=types, trips=trips, limit=limit)

    async def orientation_recenter(self, *, azimuth_deg: Optional[float] = None) -> Any:
        """The front of the ball points at this azimuth now.

        azimuth_deg: Anticlockwise seen from above; -360 to 360
        """
        return await self.call("orientation.recenter", azimuth_deg=azimuth_deg)

    async def orientation_set(self, quaternion: Mapping[str, Any]) -> Any:
        """Feeds the orientation from outside.

        quaternion: Device to world, of length 1
        """
        return await self.call("orientation.set", quaternion=quaternion)

    async def output_set_gain(self, gain: float) -> Any:
        """The owner's comfort setting for everything, stored.

        gain: Multiplies the strength; 0 to 1
        """
        return await self.call("output.set_gain", gain=gain)

    async def pattern_get(self, name: str) -> Any:
        """One named pattern with its key frames.

        name: Of a pattern: vendor/name, or that of a shipped one
        """
        return await self.call("pattern.get", name=name)

    async def pattern_list(self) -> Any:
        """The named patterns there are."""
        return await self.call("pattern.list")

    async def pattern_put(self, name: str, keyframes: List[Mapping[str, Any]], *,
                          description: Optional[str] = None, waveform: Optional[str] = None,
                          frequency_hz: Optional[float] = None, on_fraction: Optional[float] = None) -> Any:
        """Keeps a pattern under vendor/name.

        name: Of a pattern: vendor/name, or that of a shipped one
        keyframes: Where and how strongly, at points in time; t_ms never falls
        description: One sentence for whoever chooses a pattern
        waveform: Runs between 0 and the strength; constant, sine, square, triangle, sawtooth, noise
        frequency_hz: 0.5 to 250
        on_fraction: The part of a period that a square is on; 0.05 to 0.95
        """
        return await self.call("pattern.put", name=name, keyframes=keyframes, description=description,
            waveform=waveform, frequency_hz=frequency_hz, on_fraction=on_fraction)

    async def pattern_remove(self, name: str) -> Any:
        """Forgets a pattern that was put.

        name: Of a pattern: vendor/name, or that of a shipped one
        """
        return await self.call("pattern.remove", name=name)

    async def ping(self) -> Any:
        """The device time."""
        return await self.call("ping")

    async def sim_set(self, *, orientation: Optional[Mapping[str, Any]] = None,
                      ambient_c: Optional[float] = None, fault: Optional[Mapping[str, Any]] = None,
                      errors: Optional[List[Mapping[str, Any]]] = None) -> Any:
        """Changes the simulated world.

        orientation: Device to world, of length 1
        ambient_c: Temperature of the simulated room; -20 to 60
        fault: Replaces all simulated faults; {} mends the ball
        errors: Replaces all errors of measurement and of the ball; [] ends them
        """
        return await self.call("sim.set", orientation=orientation, ambient_c=ambient_c, fault=fault,
            errors=errors)

    async def sim_truth(self) -> Any:
        """The simulated ball as it really is."""
        return await self.call("sim.truth")

    async def telemetry_history(self, *, seconds: Optional[float] = None) -> Any:
        """Temperatures and currents of the last minutes.

        seconds: 1 to 600
        """
        return await self.call("telemetry.history", seconds=seconds)

    async def thermal_forecast(self, *, current_a: Optional[float] = None,
                               direction: Optional[Direction] = None, method: Optional[str] = None,
                               params: Optional[Mapping[str, Any]] = None, effect: Optional[int] = None) -> Any:
        """How long a current or an effect can flow.

        current_a: Strength as a current; at most limits.current_a; at least 0
        direction: Where the pins push out
        method: A method that plays; effect.pulse, effect.circle, effect.vibrate, effect.hold, effect.play
        params: The parameters of that method
        effect: The number of an effect, from its admission; 1 to 4294967295
        """
        return await self.call("thermal.forecast", current_a=current_a, direction=direction, method=method,
            params=params, effect=effect)
