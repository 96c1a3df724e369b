# SPDX-License-Identifier: MIT
# Runs the demo; docs/installing.md has the commands.
FROM debian:bookworm
# The launcher installs packages without questions.
ENV CI=true
COPY . /strobe
WORKDIR /strobe
RUN ./strobe --version
CMD ["./strobe", "demo"]
