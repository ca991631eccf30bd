# SPDX-License-Identifier: MIT
# Run by cmake --install: copies the documents for operators from the tree HEDGEHOG_SOURCE to the folder HEDGEHOG_DOCUMENTS of
# the prefix. Links to what is installed lead there; of other links the text remains.

# Place in the tree, name in the folder.
set(documents
    README.md README.md
    CHANGELOG.md CHANGELOG.md
    SECURITY.md security.md
    config/README.md configuration.md
    config/monitoring/README.md monitoring.md
    clients/study/troubleshooting.md study-troubleshooting.md
    clients/mqtt/README.md mqtt.md
    clients/mqtt/fleet.md mqtt-fleet.md
    clients/troubleshooting.md client-troubleshooting.md
    daemon/access.md access.md
    daemon/control/trip-reasons.md trip-reasons.md
    daemon/safety.md safety.md
    daemon/troubleshooting.md troubleshooting.md
    protocol/README.md protocol.md
    systemd/README.md systemd.md
    systemd/device-access.md device-access.md
    systemd/operate.md operate.md
    systemd/other-machines.md other-machines.md
    systemd/several-balls.md several-balls.md)
# Files elsewhere in the prefix to which documents link.
set(data
    config/hedgehogd.json ../../hedgehog/hedgehogd.json
    config/devices.d/hedgehog-86.json ../../hedgehog/devices.d/hedgehog-86.json
    config/monitoring/balls.json ../../hedgehog/monitoring/balls.json
    config/monitoring/grafana.json ../../hedgehog/monitoring/grafana.json
    config/monitoring/hedgehog.rules.yml ../../hedgehog/monitoring/hedgehog.rules.yml
    config/monitoring/scrape.yml ../../hedgehog/monitoring/scrape.yml
    protocol/schema/messages.schema.json ../../hedgehog/schema/messages.schema.json
    protocol/schema/openrpc.json ../../hedgehog/schema/openrpc.json)

# Sets `variable` to `text`, a document at the place `from` in the tree, with its links changed. A link that remains is marked by
# a colon until the others are gone.
function(hedgehog_change_links text from variable)
  get_filename_component(folder "/${from}" DIRECTORY)
  set(targets ${documents} ${data})
  while(targets)
    list(POP_FRONT targets place name)
    file(RELATIVE_PATH link "${folder}" "/${place}")
    string(REPLACE "](${link})" "](:${name})" text "${text}")
    string(REPLACE "](${link}#" "](:${name}#" text "${text}")
  endwhile()
  string(REPLACE "](#" "](:#" text "${text}")
  # Neither marked nor of the web. No picture is installed.
  string(REGEX REPLACE "!\\[[^]]*\\]\\([^:)]+\\)\n*" "" text "${text}")
  string(REGEX REPLACE "\\[([^]]*)\\]\\([^:)]+\\)" "\\1" text "${text}")
  string(REPLACE "](:" "](" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

set(left ${documents})
while(left)
  list(POP_FRONT left from name)
  set(installed "${HEDGEHOG_DOCUMENTS}/${name}")
  message(STATUS "Installing: $ENV{DESTDIR}${installed}")
  file(READ "${HEDGEHOG_SOURCE}/${from}" text)
  hedgehog_change_links("${text}" ${from} text)
  file(WRITE "$ENV{DESTDIR}${installed}" "${text}")
  file(CHMOD "$ENV{DESTDIR}${installed}" PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  list(APPEND CMAKE_INSTALL_MANIFEST_FILES "${installed}")
endwhile()
