# SPDX-License-Identifier: MIT
"""queries.py FOLDER PROMETHEUS BALL: sends Prometheus the queries of FOLDER's alert rules and panels, for a ball at rest."""
import json
import os
import re
import sys
import time
import urllib.parse
import urllib.request

TIMEOUT_S = float(os.environ.get("HEDGEHOG_PATIENCE_MS", 60000)) / 1000
# Not measured until a current has flowed.
EMPTY_AT_REST = "hedgehog_winding_r25_drift_ratio"


def query_json(server, query):
    url = f"{server}/api/v1/query?{urllib.parse.urlencode({'query': query})}"
    with urllib.request.urlopen(url, timeout=TIMEOUT_S) as response:
        response_json = json.load(response)
    assert response_json["status"] == "success", response_json
    return response_json["data"]["result"]


def rules(server):
    with urllib.request.urlopen(f"{server}/api/v1/rules", timeout=TIMEOUT_S) as response:
        return json.load(response)["data"]["groups"][0]["rules"]


def panel_queries(folder):
    with open(f"{folder}/grafana.json", encoding="utf-8") as file:
        dashboard = json.load(file)
    for panel in dashboard["panels"]:
        for target in panel["targets"]:
            yield panel["title"], target["expr"].replace("$__rate_interval", "30s").replace("$ball", ".*")


def main(folder, server, ball):
    until = time.monotonic() + TIMEOUT_S
    # A rate needs two scrapes.
    while not query_json(server, f'count_over_time(up{{instance="{ball}"}}[1m]) >= 3'):
        assert time.monotonic() < until, "Prometheus does not scrape the ball"
        time.sleep(0.2)
    assert query_json(server, f'up{{instance="{ball}"}} == 1'), "the ball does not answer Prometheus"
    served = {sample["metric"]["__name__"] for sample in query_json(server, f'{{instance="{ball}"}}')}

    panels = list(panel_queries(folder))
    failed = 0
    for title, query in panels:
        found = query_json(server, query)
        ok = bool(found) or query.endswith("> 0")
        failed += not ok
        print(f"{'ok' if ok else 'not ok'} {title}: {len(found)} series: {query}")

    with open(f"{folder}/hedgehog.rules.yml", encoding="utf-8") as file:
        text = file.read() + "".join(query for _, query in panels)
    for name in sorted(set(re.findall(r"\bhedgehog_[a-z0-9_]+", text))):
        ok = name in served or name == EMPTY_AT_REST
        failed += not ok
        print(f"{'ok' if ok else 'not ok'} {name} is served")

    while any(rule["health"] == "unknown" for rule in rules(server)):
        assert time.monotonic() < until, "Prometheus does not evaluate the rules"
        time.sleep(0.2)
    for rule in rules(server):
        # A busy machine skips ticks; an alert that is only pending has not fired.
        ok = rule["health"] == "ok" and all(alert["state"] != "firing" for alert in rule["alerts"])
        failed += not ok
        print(f"{'ok' if ok else 'not ok'} {rule['name']} does not fire")
    return failed


if __name__ == "__main__":
    sys.exit(1 if main(*sys.argv[1:]) else 0)
