# SPDX-License-Identifier: MIT
"""A game with python3-pygame: rumbles at its start, and again when the ball is tilted to the right."""
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"
import pygame  # noqa: E402

pygame.display.init()
pygame.joystick.init()
pad = pygame.joystick.Joystick(0)
print(pad.get_name(), "axes", pad.get_numaxes(), "buttons", pad.get_numbuttons(), flush=True)
print("rumble", pad.rumble(0.8, 0.0, 2000), flush=True)


def is_tilted() -> bool:
    for event in pygame.event.get():
        if event.type == pygame.JOYAXISMOTION and event.axis == 0 and event.value > 0.9:
            return True
    return False


while not is_tilted():
    pygame.time.wait(10)
print("tilted, rumble", pad.rumble(0.0, 0.5, 0), flush=True)
pygame.time.wait(300)
pad.stop_rumble()
pygame.time.wait(50)
pygame.quit()
