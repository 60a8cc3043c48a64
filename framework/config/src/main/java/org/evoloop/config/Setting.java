package org.evoloop.config;

import java.util.List;

/**
 * An option with what was given for it, as text and as what its reader has made of it.
 *
 * @param origin of the first value
 */
record Setting(Origin origin, List<String> texts, List<Object> values) {}
