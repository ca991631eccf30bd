# SPDX-License-Identifier: MIT
# Offers the ball as a node in the editor of Godot 4.
@tool
extends EditorPlugin


func _enter_tree() -> void:
	add_custom_type("HedgehogBall", "Node", preload("ball.gd"), null)


func _exit_tree() -> void:
	remove_custom_type("HedgehogBall")
