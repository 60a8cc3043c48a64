package org.evoloop.xmi.text;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.ModelInput;

/** State diagrams of Mermaid and PlantUML: in files of their own, or in blocks of Markdown. */
public final class TextDialect {
    /** How its files are called in messages. */
    public static final String NAME = "Mermaid or PlantUML";

    /** Far more than anybody writes; all of it is kept in memory. */
    private static final int MAX_BYTES = 16 << 20;

    private static final Pattern NAMES =
            Pattern.compile("(?i).*\\.(mmd|mermaid|puml|plantuml|pu|iuml|wsd|md|markdown)");
    /** Possessive, since a file may hold thousands of comments. */
    private static final Pattern MERMAID = Pattern.compile(
            "\\s*+(?:---\\R(?:(?!---)[^\\n]*+\\n)*+---\\s*+)?+(?:%%[^\\n]*+\\s*+)*+" + TextFile.DIAGRAM + ".*",
            Pattern.DOTALL);

    private static final Pattern ELSEWHERE = Pattern.compile(
            "(?m)^[ \\t]*+@start(?:uml|json|dot|salt|yaml)\\b|^[ \\t]*+(?:```+|~~~+)[ \\t]*+(?:mermaid|plantuml|puml)\\b");

    private TextDialect() {}

    /** Whether the name of the file or its beginning is that of such a text. */
    public static boolean recognises(ModelInput input) {
        if (NAMES.matcher(input.file()).matches()) {
            return true;
        }
        byte[] head = input.head();
        String text = new String(head, mark(head).charset()).replaceFirst("^\ufeff", "");
        return !text.stripLeading().startsWith("<")
                && (MERMAID.matcher(text).matches() || ELSEWHERE.matcher(text).find());
    }

    /**
     * Every machine of the file, in order, unchecked. Closes the input.
     *
     * @throws ModelException if the file as a whole cannot be read
     */
    public static List<DrawnMachine> read(ModelInput input) {
        String file = input.file();
        String text = decode(file, input.all(MAX_BYTES));
        return blocks(file, text).stream().<DrawnMachine>map(TextMachine::new).toList();
    }

    static List<TextBlock> blocks(String file, String text) {
        TextFile.Kind kind = file.toLowerCase(Locale.ROOT).matches(".*\\.(md|markdown)")
                ? TextFile.Kind.MARKDOWN
                : TextFile.Kind.of(text);
        return new TextFile(file, text, kind).blocks();
    }

    /** A byte order mark: the encoding, and its length. */
    private record Mark(Charset charset, int length) {}

    private static Mark mark(byte[] bytes) {
        if (bytes.length > 1 && (bytes[0] & bytes[1] & 0xFE) == 0xFE && bytes[0] != bytes[1]) {
            return new Mark(bytes[0] == (byte) 0xFE ? StandardCharsets.UTF_16BE : StandardCharsets.UTF_16LE, 2);
        }
        boolean utf8 =
                bytes.length > 2 && bytes[0] == (byte) 0xEF && bytes[1] == (byte) 0xBB && bytes[2] == (byte) 0xBF;
        return new Mark(StandardCharsets.UTF_8, utf8 ? 3 : 0);
    }

    private static String decode(String file, byte[] bytes) {
        Mark mark = mark(bytes);
        ByteBuffer rest = ByteBuffer.wrap(bytes, mark.length(), bytes.length - mark.length());
        CharBuffer text = CharBuffer.allocate(rest.remaining());
        CoderResult result = mark.charset().newDecoder().decode(rest, text, true);
        text.flip();
        if (result.isError()) {
            long line = 1 + text.chars().filter(letter -> letter == '\n').count();
            try {
                result.throwException();
            } catch (CharacterCodingException invalid) {
                throw new ModelException(
                        file + ": contains bytes that are not " + mark.charset() + " (line " + line
                                + "): save it in UTF-8",
                        invalid);
            }
        }
        return text.toString();
    }
}
