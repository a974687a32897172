# SPDX-License-Identifier: BSD-3-Clause
# docker build -t gaitwright . && docker run --rm -v "$PWD:/work" gaitwright walk --robot a1 --out-dir out
FROM debian:12 AS build
SHELL ["/bin/bash", "-c"]
WORKDIR /gaitwright
COPY cmake/setup.sh cmake/
RUN . cmake/setup.sh && ensure_packages $program_packages $deb_packages
COPY . .
RUN cmake --preset release -DGAITWRIGHT_TESTS=OFF -DGAITWRIGHT_PYTHON=ON && \
    cmake --build --preset release --target gaitwright python_core && \
    cd build/release && cpack -G DEB -B /packages

FROM debian:12
COPY --from=build /packages/gaitwright_*.deb /tmp/
RUN apt-get update && \
    apt-get install -y --no-install-recommends /tmp/gaitwright_*.deb && \
    rm -rf /tmp/gaitwright_*.deb /var/lib/apt/lists/*
WORKDIR /work
ENTRYPOINT ["gaitwright"]
