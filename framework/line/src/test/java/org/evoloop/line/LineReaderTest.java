package org.evoloop.line;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class LineReaderTest {
    private final List<String> complaints = new ArrayList<>();

    private List<String> lines(byte[] bytes) throws IOException {
        LineReader reader = new LineReader(new ByteArrayInputStream(bytes), complaints::add);
        List<String> lines = new ArrayList<>();
        for (String line = reader.next(); line != null; line = reader.next()) {
            lines.add(line);
        }
        return lines;
    }

    private List<String> lines(String text) throws IOException {
        return lines(text.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void linesEndWithCrLfOrBothAndEmptyOnesAreLeftOut() throws IOException {
        assertThat(lines("a\nb\r\nc\rd\n\n\r\n e \n")).containsExactly("a", "b", "c", "d", " e ");
        assertThat(complaints).isEmpty();
    }

    @Test
    void halfALineIsNone() throws IOException {
        assertThat(lines("whole\nhal")).containsExactly("whole");
    }

    @Test
    void aLineIsTextInUtf8() throws IOException {
        assertThat(lines("21 °C\n")).containsExactly("21 °C");
        assertThat(lines(new byte[] {(byte) 0xff, (byte) 0xfe, 'x', '\n', 'o', 'k', '\n'}))
                .containsExactly("ok");
        assertThat(complaints).singleElement().asString().startsWith("bytes that are not UTF-8 text are ignored");
    }

    @Test
    void theLongestLineIsTakenAndALongerOneIgnored() throws IOException {
        String longest = "x".repeat(LineReader.LONGEST);
        assertThat(lines(longest + "\n" + longest + "y\nnext\n")).containsExactly(longest, "next");
        assertThat(complaints).containsExactly("lines of more than 4096 bytes are ignored");
    }
}
