// SPDX-License-Identifier: MIT
#include "clients/study/session/participant_page.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "clients/common/terminal.h"

namespace hedgehog::study {

namespace {

constexpr std::chrono::milliseconds kKeyPoll{20};
constexpr std::chrono::milliseconds kRetryPoll{200};

std::optional<sockaddr_un> address_of(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string text = path.string();
  if (text.size() >= sizeof address.sun_path) return std::nullopt;
  std::memcpy(address.sun_path, text.c_str(), text.size() + 1);
  return address;
}

Problem cannot(int exit_code, const std::filesystem::path& path) {
  return {exit_code,
          path.string() + ": " + std::error_code(errno, std::generic_category()).message()};
}

/// A page that cannot receive it is closed; `key` detects that.
void send_cue(int page, const Cue& cue) {
  std::string line = encode(cue);
  line.push_back('\n');
  (void)::send(page, line.data(), line.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

const sockaddr* plain(const sockaddr_un& address) {
  return reinterpret_cast<const sockaddr*>(&address);
}

/// -1 if no run is listening.
int connected(const sockaddr_un& address) {
  const int server = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (server >= 0 && ::connect(server, plain(address), sizeof address) != 0) {
    ::close(server);
    return -1;
  }
  return server;
}

/// Also a run that is stopped and accepts no more pages.
bool is_listening(const sockaddr_un& address) {
  const int probe = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (probe < 0) return false;
  const bool listening = ::connect(probe, plain(address), sizeof address) == 0 || errno == EAGAIN;
  ::close(probe);
  return listening;
}

}  // namespace

Result<ParticipantServer> ParticipantServer::listen(const std::filesystem::path& path) {
  const auto address = address_of(path);
  if (!address) return Problem{EX_CANTCREAT, path.string() + ": too long for a socket's path"};
  ParticipantServer server;
  server.path_ = path;
  if (is_listening(*address))
    return Problem{EX_CANTCREAT, path.string() + ": another run in this folder has it"};
  server.listener_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  ::unlink(path.c_str());
  if (server.listener_ < 0 || ::bind(server.listener_, plain(*address), sizeof *address) != 0 ||
      ::listen(server.listener_, 2) != 0)
    return cannot(EX_CANTCREAT, path);
  return server;
}

ParticipantServer::ParticipantServer(ParticipantServer&& other) noexcept
    : path_(std::exchange(other.path_, {})),
      listener_(std::exchange(other.listener_, -1)),
      pages_(std::exchange(other.pages_, {})),
      shown_(std::move(other.shown_)) {}

ParticipantServer::~ParticipantServer() {
  for (const int page : pages_) ::close(page);
  if (listener_ >= 0) {
    ::close(listener_);
    ::unlink(path_.c_str());
  }
}

void ParticipantServer::show(const Cue& cue) {
  if (shown_ == cue) return;
  shown_ = cue;
  for (const int page : pages_) send_cue(page, cue);
}

std::optional<char> ParticipantServer::key() {
  const int fresh = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (fresh >= 0) {
    pages_.push_back(fresh);
    if (shown_) send_cue(fresh, *shown_);
  }
  std::optional<char> pressed;
  std::erase_if(pages_, [&](int page) {
    char byte = 0;
    const ssize_t count = ::recv(page, &byte, 1, 0);
    if (count == 1 && (byte == '<' || byte == '>')) pressed = byte;
    const bool gone = count == 0 || (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK);
    if (gone) ::close(page);
    return gone;
  });
  return pressed;
}

void ParticipantServer::clear_keys() {
  char bytes[64];
  for (const int page : pages_) {
    while (::recv(page, bytes, sizeof bytes, 0) > 0) {
    }
  }
}

Result<void> run_participant_page(const std::filesystem::path& path,
                                  const std::function<bool()>& stop) {
  const auto address = address_of(path);
  if (!address) return Problem{EX_NOINPUT, path.string() + ": too long for a socket's path"};
  client::Terminal terminal;
  int server = -1;
  std::string pending;
  Phase phase = Phase::kReady;  // the final screen stays until the next run
  while (!stop()) {
    if (server < 0 && (server = connected(*address)) < 0) {
      if (phase != Phase::kOver)
        terminal.draw({"", "", "", "", "", "", "", "          Please wait."});
      terminal.key(kRetryPoll);
      continue;
    }
    pollfd waiting{server, POLLIN, 0};
    if (::poll(&waiting, 1, 0) == 1) {
      char bytes[512];
      const ssize_t count = ::recv(server, bytes, sizeof bytes, 0);
      if (count <= 0) {
        ::close(std::exchange(server, -1));
        pending.clear();
        continue;
      }
      pending.append(bytes, static_cast<std::size_t>(count));
      for (auto end = pending.find('\n'); end != std::string::npos; end = pending.find('\n')) {
        const Cue cue = decode_cue(pending.substr(0, end));
        if (std::exchange(phase, cue.phase) != Phase::kQuestion && phase == Phase::kQuestion)
          terminal.discard_keys();  // keys pressed before the question are discarded
        terminal.draw(participant_lines(cue));
        pending.erase(0, end + 1);
      }
    }
    const auto key = terminal.key(kKeyPoll);
    if (key && phase == Phase::kQuestion && (key->what == '<' || key->what == '>'))
      (void)::send(server, &key->what, 1, MSG_NOSIGNAL);
  }
  if (server >= 0) ::close(server);
  return {};
}

}  // namespace hedgehog::study
