/**
 * A program's options, each declared once: read from the command line, a YAML file and the environment, checked as a
 * whole, and shown with the origin of each value.
 *
 * <p>{@code CommandLineWords} and {@code ConfigFile} turn arguments and file into entries, {@code Merge} lets the
 * former win and has each option read its values, {@code Mistakes} collects the errors.
 *
 * <p>It uses the core's help with misspelt names, and SnakeYAML Engine.
 */
@NullMarked
package org.evoloop.config;

import org.jspecify.annotations.NullMarked;
