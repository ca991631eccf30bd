// SPDX-License-Identifier: MIT
// What a game in TypeScript writes, and what its compiler has to refuse: a line after @ts-expect-error that compiles is an error.
import { Ball, discover, ErrorCode, NotConnected, RequestError } from "@hedgehog/client";
import type { Admission, BallEvent, Direction, ErrorName, Hello } from "@hedgehog/client";

export async function play(): Promise<number | null> {
  const ball = await Ball.connect({
    name: "sample",
    onReconnect: (hello: Hello) => console.log(hello.limits.felt_a),
    onSubscriptionEnded: (error) => console.log(error.method, error.reason === "forbidden"),
  });
  const side: Direction = [0, 1, 0];
  const admission: Admission = await ball.pulse(side, { level: 0.5, on_close: "finish" });
  await ball.circle("up", { duration_ms: 1500, sense: "cw" });
  await ball.play("heartbeat", { loop: true, lease_ms: 2000, rotate_to: { azimuth_deg: 90 } });
  const felt: boolean = ball.rumble("engine", 0.3, "back", { frequency_hz: 70 });
  const status = await ball.call("device.status");
  const model: number | null = status.temperature_c.model;
  const unknown: unknown = await ball.call("of.the.future", { x: 1 });
  console.log(admission.effect + 1, felt, unknown, model?.toFixed(1));
  return model;
}

export async function follow(ball: Ball): Promise<void> {
  for await (const event of ball.events(["effect_ended", "state_changed"], { scope: "all" })) {
    const delivered: number | undefined = event.delivered?.mean;
    console.log(event.type, event.time_ns, delivered);
  }
  for await (const status of ball.telemetry(10, ["temperature_c", "effects"])) console.log(status.temperature_c?.model);
  for await (const [method, params] of ball.notifications()) if (method === "event") told(params as BallEvent);
}

function told(event: BallEvent): void {
  console.log(event.reason ?? "");
}

export async function find(): Promise<string[]> {
  return (await discover(500)).filter((ball) => ball.tls).map((ball) => `${ball.name} at ${ball.address}:${ball.port}, ${ball.serial ?? "unknown"}`);
}

export function explain(error: unknown): string {
  if (error instanceof NotConnected) return `again in ${error.retryAfterMs} ms`;
  if (!(error instanceof RequestError)) throw error;
  const name: ErrorName = "refused_thermal";
  if (error.code === ErrorCode.invalid_params) return `${error.data.field}: ${error.message}`;
  return error.reason === name ? "too warm" : error.message;
}

export async function typeErrors(ball: Ball): Promise<void> {
  // @ts-expect-error: the time is a number of milliseconds
  await discover("1 s");
  // @ts-expect-error: no such direction
  await ball.pulse("sideways");
  // @ts-expect-error: level is a number
  await ball.pulse("left", { level: "0.5" });
  // @ts-expect-error: no such parameter
  await ball.pulse("left", { leval: 0.5 });
  // @ts-expect-error: no such waveform
  await ball.vibrate("down", { waveform: "sinus" });
  // @ts-expect-error: the direction is missing
  await ball.hold();
  // @ts-expect-error: no such field of the result
  (await ball.status()).temperature;
  // @ts-expect-error: it may be null
  (await ball.status()).temperature_c.model.toFixed(1);
  // @ts-expect-error: no such event
  ball.events(["effect_over"]);
  // @ts-expect-error: no such field of the status
  ball.telemetry(10, ["temperatur_c"]);
  // @ts-expect-error: no such error
  ErrorCode.too_warm;
}
