// SPDX-License-Identifier: MIT
// HTTP and WebSocket of a real daemon: access control, the content of each path, and /ws as the
// same protocol as TCP, errors included.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "tests/e2e/program.h"
#include "tests/e2e/web_fixture.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(Web, ServesOnlyThePages) {
  const WebResponse index = get("/");
  EXPECT_EQ(index.status, 200);
  EXPECT_THAT(index.body, HasSubstr("<title>ball"));
  EXPECT_EQ(index.header("content-type"), "text/html; charset=utf-8");
  EXPECT_THAT(index.header("content-security-policy"), HasSubstr("script-src 'self'"));
  EXPECT_EQ(index.header("x-content-type-options"), "nosniff");
  EXPECT_EQ(get("/index.html?x=/../..").body, index.body);
  EXPECT_EQ(get("/app.js").header("content-type"), "text/javascript; charset=utf-8");
  EXPECT_EQ(get("/deep/style.css").status, 200);
  for (const std::string path : {"/secret.key", "/../outside.html", "/www/../../outside.html",
                                 "/%2e%2e/outside.html", "//index.html", "/deep", "/deep/", "*"})
    EXPECT_EQ(get(path).status, 404) << path;
}

TEST_F(Web, ARecordingIsServedByItsTripAndNothingElseOfTheStateDirectory) {
  for (const std::string path :
       {"/recordings/", "/recordings/trip-0001.hhr", "/recordings/trip-0001",
        "/recordings/state.json", "/recordings/../state.json",
        "/recordings/trip-0001.hhr/../state.json"})
    EXPECT_EQ(get(path).status, 404) << path;
}

TEST_F(Web, APageThatHasNotChangedIsNotSentAgain) {
  const std::string etag = get("/app.js").header("etag");
  ASSERT_FALSE(etag.empty());
  EXPECT_EQ(get("/app.js").header("cache-control"), "no-cache");
  const WebResponse same = get("/app.js", "If-None-Match: " + etag + "\r\n");
  EXPECT_EQ(same.status, 304);
  EXPECT_EQ(same.body, "");
  EXPECT_EQ(get("/app.js", "If-None-Match: \"old\"\r\n").status, 200);
}

TEST_F(Web, HeadIsGetWithoutTheBody) {
  const WebResponse head = get("/app.js", "", "HEAD");
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.header("content-length"), "10");
  EXPECT_EQ(head.body, "");
}

TEST_F(Web, OnlyTheOwnHostNamesAreServed) {
  const std::string port = std::to_string(daemon_.http_port());
  const std::string with_port = "127.0.0.1:" + port;
  for (const char* host : {"localhost:1", "LOCALHOST", with_port.c_str(), "127.9.9.9", "[::1]:7"})
    EXPECT_EQ(get("/healthz", std::string("Host: ") + host + "\r\n").status, 200) << host;
  for (const std::string host : {"evil.example", "127.0.0.1.evil.example", "localhost.evil.example",
                                 "127.1", "128.0.0.1", "[::1", "localhost:x", "", "[::2]"}) {
    const WebResponse response = get("/healthz", "Host: " + host + "\r\n");
    EXPECT_EQ(response.status, 421) << host;
    EXPECT_THAT(response.body, HasSubstr("is not a name of this machine"));
  }
  EXPECT_EQ(web_send(daemon_.http_port(), "GET / HTTP/1.1\r\nConnection: close\r\n\r\n").status,
            421);
  EXPECT_EQ(get("/", "Host: localhost\r\nHost: evil.example\r\n").status, 421);
}

TEST_F(Web, ForeignPagesAreRefusedWithTheNameOfTheKey) {
  const std::string own =
      "Origin: http://localhost:" + std::to_string(daemon_.http_port()) + "\r\n";
  EXPECT_EQ(get("/", own).status, 200);
  EXPECT_EQ(get("/", "Origin: https://game.example\r\n").status, 200);
  for (const std::string origin : {"https://evil.example", "null", "http://game.example",
                                   "http://localhost:1", "https://game.example.evil"}) {
    const std::string header = "Origin: " + origin + "\r\n";
    EXPECT_EQ(get("/", header).status, 403) << origin;
    const WebSocketClient refused(daemon_.http_port(), header);
    EXPECT_EQ(refused.response().status, 403) << origin;
  }
  EXPECT_EQ(get("/", own + "Origin: https://evil.example\r\n").status, 403) << "neither of two";
  EXPECT_TRUE(
      daemon_.logs("pages of https://evil.example may not connect: add that origin to "
                   "http.allow_origins"));
  EXPECT_EQ(
      WebSocketClient(daemon_.http_port(), "Origin: https://game.example\r\n").response().status,
      101);
  EXPECT_EQ(WebSocketClient(daemon_.http_port(), "Host: evil.example\r\n").response().status, 421);
  EXPECT_EQ(metric(R"(hedgehog_connections_rejected_total{device="ball",reason="origin"})"), 11);
}

// Fetch Metadata (W3C): a request for an image, script or link has no Origin, but a Sec-Fetch-Site
// header.
TEST_F(Web, EmbeddingByForeignPagesIsRefusedWithoutAnOriginToo) {
  const auto fetched = [&](const std::string& path, const std::string& site,
                           const std::string& mode) {
    return get(path, "Sec-Fetch-Site: " + site + "\r\nSec-Fetch-Mode: " + mode + "\r\n").status;
  };
  const std::string recording = "/recordings/trip-0001.hhr";
  for (const std::string site : {"cross-site", "same-site"}) {
    for (const std::string& path : {recording, std::string("/metrics"), std::string("/app.js")})
      EXPECT_EQ(fetched(path, site, "no-cors"), 403) << path;
    EXPECT_EQ(fetched("/", site, "navigate"), 200) << "a link to the dashboard";
    EXPECT_EQ(fetched(recording, site, "navigate"), 403) << "a download that nobody asked for";
  }
  for (const std::string site : {"same-origin", "none"}) {
    EXPECT_EQ(fetched("/app.js", site, "no-cors"), 200);
    EXPECT_EQ(fetched(recording, site, "navigate"), 404) << "there is none, but one may ask";
  }
  const std::string allowed = "Origin: https://game.example\r\nSec-Fetch-Site: cross-site\r\n";
  EXPECT_EQ(get("/metrics", allowed + "Sec-Fetch-Mode: cors\r\n").status, 200);
  EXPECT_EQ(metric(R"(hedgehog_connections_rejected_total{device="ball",reason="origin"})"), 8);
}

TEST_F(Web, InvalidAndOversizedRequestsAreRefused) {
  const int port = daemon_.http_port();
  EXPECT_EQ(web_send(port, kPingRequest + "\n\r\n\r\n").status, 400);
  EXPECT_EQ(web_send(port, std::string("\0\xff\x16\x03\x01\r\n\r\n", 9)).status, 400);
  EXPECT_EQ(get("/", "X: " + std::string(9000, 'x') + "\r\n").status, 431);
  EXPECT_EQ(web_send(port, "GET /" + std::string(20'000, 'x')).status, 431);
  const WebResponse post = get("/", "Content-Length: 2\r\n\r\n{}", "POST");
  EXPECT_EQ(post.status, 405);
  EXPECT_EQ(post.header("allow"), "GET, HEAD");
  EXPECT_EQ(get("/", "Content-Length: 100000\r\n", "POST").status, 413);
  EXPECT_EQ(get("/ws").status, 426);
  // Half a request, and a client that sends nothing, do not affect other clients.
  RawClient half(port);
  half.send("GET / HT");
  half.half_close();
  EXPECT_THAT(half.bytes().value_or(""), Not(HasSubstr("200")));
  EXPECT_EQ(get("/healthz").body, "ok\narmed\n");
}

TEST_F(Web, OneConnectionServesSeveralRequests) {
  RawClient socket(daemon_.http_port());
  const std::string request = "GET /app.js HTTP/1.1\r\nHost: localhost\r\n\r\n";
  socket.send(request + request);
  std::string both;
  while (both.find("export {};") == both.rfind("export {};")) {
    const auto more = socket.bytes();
    ASSERT_TRUE(more);
    both += *more;
  }
}

TEST_F(Web, MetricsIntegrateBetweenTwoScrapes) {
  EXPECT_TRUE(eventually(
      [&] { return metric(R"(hedgehog_device_state{device="ball",state="armed"})") == 1; }));
  EXPECT_GT(metric(R"(hedgehog_temperature_celsius{device="ball",source="sensor"})"), 10);
  EXPECT_EQ(metric(R"(hedgehog_temperature_celsius{device="ball",source="second"})"), -1);
  EXPECT_EQ(metric(R"(hedgehog_heat_ampere_squared_seconds_total{device="ball"})"), 0);
  WebSocketClient web(daemon_.http_port());
  web.call("events.subscribe", {{"types", {"effect_ended"}}});
  web.call("effect.pulse", {{"direction", "front"}, {"current_a", 10}, {"duration_ms", 200}});
  EXPECT_EQ(web.json()["params"]["reason"], "completed");
  // 10 A for 0.2 s are 20 A²s, plus or minus the slopes.
  EXPECT_TRUE(eventually(
      [&] { return metric(R"(hedgehog_heat_ampere_squared_seconds_total{device="ball"})") > 10; }));
  EXPECT_LT(metric(R"(hedgehog_heat_ampere_squared_seconds_total{device="ball"})"), 25);
  EXPECT_GT(metric(R"(hedgehog_on_seconds_total{device="ball",coil="x"})"), 0.01);
  EXPECT_EQ(
      metric(R"(hedgehog_effects_total{device="ball",method="effect.pulse",outcome="completed"})"),
      1);
  EXPECT_EQ(metric(R"(hedgehog_requests_total{device="ball",method="effect.pulse",code="0"})"), 1);
  EXPECT_EQ(metric(R"(hedgehog_request_to_coil_seconds_count{device="ball"})"), 1);
  for (const char* ticks : {R"(hedgehog_tick_lateness_seconds_bucket{device="ball",le="+Inf"})",
                            R"(hedgehog_tick_work_seconds_count{device="ball"})"})
    EXPECT_TRUE(eventually([&] { return metric(ticks) > 100; })) << ticks;
}

TEST_F(Web, CountersWithKnownLabelsStartAtZero) {
  for (const char* name :
       {R"(hedgehog_trips_total{device="ball",reason="overheated"})",
        R"(hedgehog_trips_total{device="ball",reason="sensor_frozen"})",
        R"(hedgehog_trips_total{device="ball",reason="no_board"})",
        R"(hedgehog_effects_limited_total{device="ball",by="thermal"})",
        R"(hedgehog_effects_total{device="ball",method="effect.play",)"
        R"(outcome="tripped"})",
        R"(hedgehog_connections_rejected_total{device="ball",reason="slow"})",
        R"(hedgehog_requests_total{device="ball",method="none",code="-32700"})",
        R"(hedgehog_requests_total{device="ball",method="none",code="-32601"})",
        R"(hedgehog_requests_total{device="ball",method="none",code="-32602"})",
        R"(hedgehog_requests_total{device="ball",method="device.arm",code="0"})"})
    EXPECT_EQ(metric(name), 0) << name;
}

TEST_F(Web, MetricsHaveTheHottestAndEachWinding) {
  const std::string text = get("/metrics").body;
  const auto at = [&](const char* line) { return text.find(line); };
  EXPECT_LT(at(R"(hedgehog_temperature_celsius{device="ball",source="model"})"),
            at(R"(hedgehog_temperature_celsius{device="ball",source="sensor"})"));
  for (const char* family : {"temperature_celsius", "temperature_threshold_celsius"}) {
    const std::size_t help = at(("# HELP hedgehog_" + std::string(family) + " ").c_str());
    ASSERT_NE(help, std::string::npos) << family;
    EXPECT_THAT(text.substr(help, text.find('\n', help) - help), HasSubstr("hottest winding"));
  }
  EXPECT_GT(metric(R"(hedgehog_temperature_celsius{device="ball",source="upper"})"), 10);
  for (const char* coil : {"x", "y", "z"}) {
    EXPECT_GT(metric(R"(hedgehog_winding_temperature_celsius{device="ball",coil=")" +
                     std::string(coil) + "\"}"),
              10);
  }
}

TEST_F(Web, MetricsHaveTheResourcesOfTheProcess) {
  EXPECT_GT(metric("process_cpu_seconds_total"), 0);
  EXPECT_GT(metric("process_open_fds"), 5);
  EXPECT_GE(metric("process_max_fds"), metric("process_open_fds"));
  EXPECT_GT(metric("process_resident_memory_bytes"), 1e6);
  EXPECT_GT(metric("process_virtual_memory_bytes"), metric("process_resident_memory_bytes"));
  EXPECT_GT(metric("process_threads"), 3);
  EXPECT_GT(metric("process_start_time_seconds"), 1.6e9);
}

/// Every metric family has a description of a whole sentence.
TEST_F(Web, MetricsAreExplained) {
  std::istringstream text(get("/metrics").body);
  int families = 0;
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with("# HELP ")) continue;
    ++families;
    EXPECT_GE(std::count(line.begin(), line.end(), ' '), 6) << line;
  }
  EXPECT_GT(families, 30);
}

TEST(WebOff, IsDisabledByConfiguration) {
  Home home;
  home.configure(R"({"http": {"listen": null}})");
  const DaemonProcess daemon(home);
  EXPECT_EQ(daemon.http_port(), 0);
}

TEST(WebOff, WithoutPagesTheRestWorksAndItIsLogged) {
  Home home;
  home.configure(R"({"http": {"pages": "/nowhere"}})");
  const DaemonProcess daemon(home);
  const WebResponse response = web_get(daemon.http_port(), "/");
  EXPECT_EQ(response.status, 404);
  EXPECT_THAT(response.body, HasSubstr("/nowhere: No such file or directory"));
  EXPECT_EQ(web_get(daemon.http_port(), "/healthz").status, 200);
}

}  // namespace
}  // namespace hedgehog::e2e
