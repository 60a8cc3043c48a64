package org.evoloop.program.prometheus;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads Prometheus's text format, version 0.0.4, strictly according to its specification. */
final class Scrape {
    private static final String NAME = "[a-zA-Z_:][a-zA-Z0-9_:]*";
    private static final Pattern COMMENT = Pattern.compile("# (HELP|TYPE) (" + NAME + ") (.+)");
    private static final String LABEL = "[a-zA-Z_][a-zA-Z0-9_]*=\"(?:[^\"\\\\]|\\\\[\\\\n\"])*\"";
    private static final Pattern SAMPLE =
            Pattern.compile("((" + NAME + ")(?:\\{" + LABEL + "(?:," + LABEL + ")*})?) ([-+0-9.eE]+|NaN|[-+]Inf)");

    private Scrape() {}

    /**
     * The samples by name and labels. Fails if a line is malformed, without a family, outside its family's group, or a
     * duplicate.
     */
    static Map<String, Double> read(String text) {
        assertThat(text).endsWith("\n");
        Map<String, Double> samples = new TreeMap<>();
        Set<String> over = new HashSet<>();
        String family = "";
        for (String line : text.lines().toList()) {
            Matcher comment = COMMENT.matcher(line);
            if (comment.matches()) {
                if (!comment.group(2).equals(family)) {
                    over.add(family);
                    family = comment.group(2);
                    assertThat(over)
                            .as("families that had ended before " + line)
                            .doesNotContain(family);
                }
                if (comment.group(1).equals("TYPE")) {
                    assertThat(comment.group(3)).isIn("counter", "gauge", "summary", "histogram", "untyped");
                }
                continue;
            }
            Matcher sample = SAMPLE.matcher(line);
            assertThat(sample.matches()).as(line).isTrue();
            assertThat(sample.group(2)).as(line).startsWith(family);
            String value = sample.group(3).replace("Inf", "Infinity");
            assertThat(samples.put(sample.group(1), Double.valueOf(value)))
                    .as(line)
                    .isNull();
        }
        return samples;
    }
}
