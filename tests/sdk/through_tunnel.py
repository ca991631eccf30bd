#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A program with a simulated daemon behind TLS: through_tunnel.py HEDGEHOGD COMMAND..., to which the address of a tunnel is added."""

import subprocess
import sys

from live_daemon import LiveDaemon, Tunnel


def main():
    # The tests watch the effects of others, too.
    daemon = LiveDaemon(sys.argv[1], role="operate")
    try:
        tunnel = Tunnel(sys.argv[1], daemon)
        try:
            return subprocess.run([*sys.argv[2:], tunnel.address], check=False).returncode
        finally:
            tunnel.stop()
    finally:
        daemon.stop()


if __name__ == "__main__":
    sys.exit(main())
