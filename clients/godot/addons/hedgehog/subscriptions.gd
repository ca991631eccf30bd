# SPDX-License-Identifier: MIT
# What a program subscribed to, for the next connection. The daemon keeps one subscription of each kind for a connection: of several
# requests of a kind the one that was sent last holds, in whichever order they are answered.

const BEGIN := ".subscribe"
const END := ".unsubscribe"

# By kind ("events"): the changes that were not refused, oldest first; the newest holds, or will.
var _changes := {}


# The program asks for it now. `request`: has the answer; null: there will be none.
func change(request, method: String, params: Dictionary) -> void:
	var kind = _kind(method)
	if kind == "":
		return
	if request == null or not _changes.has(kind):
		_changes[kind] = []
	_changes[kind].append({"request": request, "method": method, "params": params, "renewal": false})


# What a new connection has to be asked for: changes, whose `request` and `renewal` are for `renew`.
func current() -> Array:
	var due := []
	for kind in _changes:
		var newest = _newest(kind)
		if newest != null:
			_changes[kind] = [newest]
			if newest.method.ends_with(BEGIN):
				due.append(newest)
	return due


# `one` of `current` is asked for again.
func renew(one: Dictionary, request) -> void:
	one.request = request
	one.renewal = true


# The daemon's answer. True: it has refused to renew a subscription, which has ended.
func answered(request, accepted: bool) -> bool:
	var kind = _kind(request.method)
	var all = _changes.get(kind, [])
	for at in range(all.size()):
		if all[at].request == request:
			var ended = all[at].renewal and not accepted and at == all.size() - 1
			_settle(kind, at, accepted)
			return ended
	return false


# What is older than an accepted one holds no more; a refused one never did.
func _settle(kind: String, settled: int, accepted: bool) -> void:
	var kept := []
	for at in range(_changes[kind].size()):
		if at > settled or (at == settled and accepted) or (at < settled and not accepted):
			kept.append(_changes[kind][at])
	_changes[kind] = kept


func _newest(kind: String):
	var all = _changes[kind]
	return all[all.size() - 1] if all.size() > 0 else null


func _kind(method: String) -> String:
	for verb in [BEGIN, END]:
		if method.ends_with(verb):
			return method.substr(0, method.length() - verb.length())
	return ""
