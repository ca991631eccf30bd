#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""fleet.py BUILD DAEMONS SECONDS: simulated daemons of BUILD, each with hedgehog-mqtt, at one mosquitto and one Prometheus.

The balls advance by 10 ms at a time, not by 1 ms as a single simulated ball does: a wake-up costs more than ten ticks.
Prints processor time and memory of each kind of program, and what is missing: telemetry by the device times of consecutive
messages of a ball and by the broker's count of dropped messages (up to 10 s old), scrapes by Prometheus' `up`. On a machine with too
few processors the simulated balls are slower than real time: the slowest one is printed, and no failure.
Exit: 143 terminated; 1 a daemon or a bridge ended early, a ball sent no telemetry, nothing was scraped, or the broker dropped messages.
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import urllib.parse
import urllib.request

BUILD, DAEMONS, SECONDS = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]), float(sys.argv[3])
HZ = 1
SCRAPE_S = 5
IN_STEP = ("--simulate", "--speed", "1", "--step-ms", "10")
TICKS = os.sysconf("SC_CLK_TCK")


class Fleet:
    def __init__(self, folder):
        self.folder = folder
        self.running = []  # (kind, process)

    def start(self, kind, argv, **more):
        more.setdefault("stderr", open(self.folder / f"{kind}.log", "ab"))
        process = subprocess.Popen([str(word) for word in argv], stdin=subprocess.DEVNULL, **more)
        self.running.append((kind, process))
        return process

    def daemon(self, number):
        """Starts a daemon and its bridge; returns the address of the daemon's pages."""
        home = self.folder / f"ball-{number}"
        (home / "config/hedgehog").mkdir(parents=True)
        (home / "run").mkdir()
        (home / "config/hedgehog/hedgehogd.json").write_text('{"http": {"listen": "127.0.0.1:0"}}')
        env = dict(os.environ, HOME=str(home), XDG_RUNTIME_DIR=str(home / "run"), XDG_STATE_HOME=str(home / "state"),
                   XDG_CONFIG_HOME=str(home / "config"))
        process = self.start("hedgehogd", [BUILD / "daemon/hedgehogd", *IN_STEP, "--listen", "127.0.0.1:0"],
                             env=env, stdout=subprocess.PIPE, text=True)
        for line in process.stdout:
            if "http://" in line:
                pages = line.strip().rsplit("/", 1)[1]
            if "listening on /" in line:
                break
        self.start("hedgehog-mqtt", [BUILD / "clients/mqtt/hedgehog-mqtt", "--address",
                                     home / "run/hedgehog/hedgehogd.sock", "--broker", self.folder / "broker.sock",
                                     "--id", f"ball-{number}", "--telemetry-hz", HZ, "--home-assistant", "no"])
        return pages

    def usage(self):
        """Seconds of processor time and bytes of memory, by kind."""
        sums = {}
        for kind, process in self.running:
            fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
            cpu, memory, count = sums.get(kind, (0.0, 0, 0))
            sums[kind] = (cpu + (int(fields[11]) + int(fields[12])) / TICKS,
                          memory + int(fields[21]) * os.sysconf("SC_PAGE_SIZE"), count + 1)
        return sums

    def end(self):
        for _, process in self.running:
            process.terminate()
        for _, process in self.running:
            process.wait()


def first_line_with(path, text):
    while True:
        for line in path.read_text().splitlines():
            if text in line:
                return line
        time.sleep(0.1)


def query(prometheus, expression):
    url = f"http://{prometheus}/api/v1/query?" + urllib.parse.urlencode({"query": expression})
    result = json.load(urllib.request.urlopen(url))["data"]["result"]
    return int(float(result[0]["value"][1])) if result else 0


def telemetry_of(lines):
    """For each topic its messages, as pairs of the times of arrival and of the ball, s."""
    topics = {}
    for line in lines:
        arrival, topic, payload = line.split(" ", 2)
        topics.setdefault(topic, []).append((float(arrival), json.loads(payload)["time_ns"] / 1e9))
    return topics


def missing(messages):
    """Periods of the ball's time without a message."""
    return sum(max(0, round((after - before) * HZ) - 1) for (_, before), (_, after) in zip(messages, messages[1:]))


def pace(messages):
    """Of the ball's time, beside real time."""
    (begun, first), (ended, last) = messages[0], messages[-1]
    return (last - first) / max(ended - begun, 1e-9)


def dropped(socket):
    """What the broker did not pass on to its subscribers. It publishes this number once there is one, and retains it."""
    out = subprocess.run(["mosquitto_sub", "--unix", socket, "--retained-only", "-W", "30", "-t", "$SYS/broker/publish/messages/+", "-F", "%t %p"],
                         check=False, capture_output=True, text=True).stdout
    counts = {topic.rsplit("/", 1)[1]: int(count) for topic, count in map(str.split, out.splitlines())}
    if not counts.get("sent"):
        sys.exit("tests/fleet: the broker does not say how many messages it sent")
    return counts.get("dropped", 0)


def main(folder):
    fleet = Fleet(folder)
    try:
        (folder / "mosquitto.conf").write_text(
            f"listener 0 {folder}/broker.sock\nallow_anonymous true\nuser {os.environ.get('USER', 'root')}\n")
        fleet.start("mosquitto", ["/usr/sbin/mosquitto", "-c", folder / "mosquitto.conf"])
        while not (folder / "broker.sock").exists():
            time.sleep(0.1)
        pages = [fleet.daemon(number) for number in range(DAEMONS)]
        config = {"global": {"scrape_interval": f"{SCRAPE_S}s"},
                  "scrape_configs": [{"job_name": "hedgehog", "static_configs": [{"targets": pages}]}]}
        (folder / "prometheus.yml").write_text(json.dumps(config))
        fleet.start("prometheus", ["prometheus", f"--config.file={folder}/prometheus.yml",
                                   f"--storage.tsdb.path={folder}/data", "--web.listen-address=127.0.0.1:0"])
        prometheus = first_line_with(folder / "prometheus.log", 'msg="Listening on" address=').rsplit("=", 1)[1]
        with open(folder / "telemetry", "wb") as telemetry:
            fleet.start("mosquitto_sub", ["mosquitto_sub", "--unix", folder / "broker.sock", "-V", "5", "-t",
                                          "hedgehog/+/telemetry", "-F", "%U %t %p"], stdout=telemetry)
        before, begun = fleet.usage(), time.monotonic()
        time.sleep(SECONDS)
        ended = [kind for kind, process in fleet.running if process.poll() is not None]
        if ended:
            sys.exit(f"tests/fleet: ended early: {ended}")
        after, took = fleet.usage(), time.monotonic() - begun
        span = f"{int(SECONDS)}s"
        scrapes = query(prometheus, f"sum(count_over_time(up[{span}]))")
        failed = query(prometheus, f"sum(count_over_time(up[{span}]) - sum_over_time(up[{span}]))")
        dropped_by_broker = dropped(folder / "broker.sock")
    finally:
        fleet.end()
    print(f"{DAEMONS} daemons, {took:.0f} s, {os.cpu_count()} processors")
    print("| program | number | processor time, % of one | memory, MB |\n|---|---|---|---|")
    for kind, (cpu, memory, count) in after.items():
        print(f"| {kind} | {count} | {100 * (cpu - before[kind][0]) / took:.1f} | {memory / 1e6:.0f} |")
    balls = telemetry_of((folder / "telemetry").read_text().splitlines()).values()
    print(f"telemetry: {sum(map(len, balls))} messages of {len(balls)} balls, {sum(map(missing, balls))} missing, "
          f"{dropped_by_broker} dropped by the broker; slowest ball {min(map(pace, balls), default=0):.2f} × real time")
    print(f"scrapes: {DAEMONS * SECONDS / SCRAPE_S:.0f} due, {scrapes} made, {failed} of them failed")
    if len(balls) != DAEMONS or not scrapes:
        sys.exit("tests/fleet: not every ball was heard of")
    if dropped_by_broker:
        sys.exit("tests/fleet: the broker dropped messages")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    # So that SIGTERM also ends the started programs.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    with tempfile.TemporaryDirectory() as place:
        main(pathlib.Path(place))
