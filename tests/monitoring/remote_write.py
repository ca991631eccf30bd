# SPDX-License-Identifier: MIT
"""remote_write.py FOLDER FIRST SECOND BALL: a ball that the Prometheus FIRST scrapes, in SECOND, to which FIRST sends.

SECOND must have each metric of the alert rules of FOLDER that FIRST has, and nothing else of the ball.
"""
import re
import sys
import time

from queries import TIMEOUT_S, query_json


def names(server, ball):
    return {sample["metric"]["__name__"] for sample in query_json(server, f'{{instance="{ball}"}}')}


def main(folder, first, second, ball):
    with open(f"{folder}/hedgehog.rules.yml", encoding="utf-8") as file:
        of_rules = {"up"} | set(re.findall(r"\bhedgehog_[a-z0-9_]+", file.read()))
    scraped = names(first, ball)
    expected = of_rules & scraped
    assert {"up", "hedgehog_device_state"} <= expected < scraped, scraped
    until = time.monotonic() + TIMEOUT_S
    while not expected <= (received := names(second, ball)):
        assert time.monotonic() < until, f"not received: {sorted(expected - received)}"
        time.sleep(0.2)
    states = query_json(second, f'sum(hedgehog_device_state{{instance="{ball}", job="hedgehog", place="laboratory"}}) == 1')
    ok = received == expected and len(states) == 1
    print(f"{'ok' if ok else 'not ok'} the second Prometheus received {len(received)} of {len(scraped)} metrics: {', '.join(sorted(received))}")
    return 0 if ok else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
