/**
 * A program's options, each declared once: read from the command line, a YAML file and the environment, checked as a
 * whole, and shown with the origin of each value.
 *
 * <p>Picocli reads the command line and prints the help. {@code ConfigFile} turns a file into entries, {@code Reading}
 * has picocli read those that the command line does not have, as if they were in front of it, {@code Mistakes} collects
 * the errors.
 *
 * <p>It uses the core's help with misspelt names, picocli, and SnakeYAML Engine.
 */
@NullMarked
package org.evoloop.config;

import org.jspecify.annotations.NullMarked;
