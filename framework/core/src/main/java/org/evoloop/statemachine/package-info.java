/**
 * State machines as the paper defines them, Sys = (E, S, T) with an initial state (section IV.A): immutable, flat and
 * deterministic by construction.
 *
 * <p>This package uses nothing of Evoloop. It knows no files, threads or clocks.
 */
@NullMarked
package org.evoloop.statemachine;

import org.jspecify.annotations.NullMarked;
