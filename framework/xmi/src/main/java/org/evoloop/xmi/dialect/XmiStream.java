package org.evoloop.xmi.dialect;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import javax.xml.XMLConstants;
import javax.xml.stream.Location;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.util.StreamReaderDelegate;
import org.evoloop.statemachine.ModelException;
import org.jspecify.annotations.Nullable;

/**
 * The parser of one file: namespace-aware, without DTDs and entities, and with limits on everything by which a file can
 * make a parser or its caller use memory. Each refusal is a {@link ModelException} that names the file and the line.
 */
public final class XmiStream extends StreamReaderDelegate implements AutoCloseable {
    /** Astah nests two levels per package and two per composite state. */
    private static final int MAX_DEPTH = 500;

    /** The parser keeps every name in memory; a real file has some 200. */
    private static final int MAX_NAMES = 10_000;

    private static final int MAX_NAME_CHARACTERS = 1_000;
    /** Enough for 100,000 transitions. */
    private static final int MAX_KEPT_BYTES = 256 << 20;
    /** The approximate memory for an element, besides its texts. */
    private static final int BYTES_PER_ELEMENT = 140;

    static final String EXPORT_AGAIN = "export it again from the tool that wrote it";

    private final String file;
    private final BoundedInput input;
    private final Set<String> names = new HashSet<>();
    private int depth;
    private long keptBytes;
    private int strayTextLine;

    private XmiStream(String file, InputStream bytes) {
        this.file = file;
        this.input = new BoundedInput(bytes, this::refuse);
    }

    /**
     * Opens a file.
     *
     * @throws ModelException if it cannot be opened or does not begin like XML
     */
    public static XmiStream open(Path file) {
        return of(ModelInput.open(file));
    }

    /**
     * Parses what is left of the input, takes ownership of it and closes it.
     *
     * @throws ModelException if it does not begin like XML
     */
    public static XmiStream of(ModelInput opened) {
        String file = opened.file();
        XmiStream stream = new XmiStream(file, opened.bytes());
        try {
            Charset encoding = stream.encoding(opened.head());
            // A new decoder reports invalid bytes; the default decoder of a reader would replace them silently.
            stream.setParent(
                    factory().createXMLStreamReader(new InputStreamReader(stream.input, encoding.newDecoder())));
            return stream;
        } catch (XMLStreamException notXml) {
            stream.close();
            throw stream.notXml(notXml);
        } catch (IOException unreadable) {
            stream.close();
            throw new ModelException(file + ": cannot be read (" + unreadable.getMessage() + ")", unreadable);
        } catch (RuntimeException refused) {
            stream.close();
            throw refused;
        }
    }

    private static XMLInputFactory factory() {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
        // The parser's own limits differ between JDKs, and can be set from outside. The depth is limited here.
        factory.setProperty("jdk.xml.maxElementDepth", 0);
        factory.setProperty("jdk.xml.elementAttributeLimit", MAX_NAMES);
        factory.setProperty("jdk.xml.maxXMLNameLimit", MAX_NAME_CHARACTERS);
        return factory;
    }

    private Charset encoding(byte[] head) throws IOException {
        if (head.length == 0) {
            throw refuse("is empty", EXPORT_AGAIN);
        }
        if (head[0] == 0x1F) {
            throw refuse("is compressed by gzip", "unpack it with gunzip");
        }
        Optional<ForeignFormat> foreign = ForeignFormat.of(file, head);
        if (foreign.isPresent()) {
            throw refuse(foreign.get());
        }
        if (head[0] == 'P' && head.length > 1 && head[1] == 'K') {
            throw refuse(
                    "is a zip archive, such as an Astah project (.asta), not XML",
                    "open it in Astah and use Tools > XML Input & Output > Save as XML Project");
        }
        input.skipNBytes(XmlEncoding.utf8MarkBytes(head));
        try {
            return XmlEncoding.of(Arrays.copyOf(head, Math.min(head.length, XmlEncoding.HEAD_BYTES)));
        } catch (IllegalArgumentException unknown) {
            throw refuse("is in the unknown encoding " + unknown.getMessage(), "save it in UTF-8");
        }
    }

    /** The file's name, for messages. */
    public String file() {
        return file;
    }

    /** The number of open elements, including the current one. */
    public int depth() {
        return depth;
    }

    /** The current line, counted from 1. */
    public int line() {
        return getLocation().getLineNumber();
    }

    /** The first line with text directly in the root; 0 if there is none so far. */
    public int strayTextLine() {
        return strayTextLine;
    }

    /** Advances to the next start tag. Returns false at the end of the element that is open at {@code outerDepth}. */
    public boolean nextElementWithin(int outerDepth) {
        while (true) {
            int event = next();
            if (event == XMLStreamConstants.START_ELEMENT) {
                return true;
            }
            if (event == XMLStreamConstants.END_DOCUMENT
                    || (event == XMLStreamConstants.END_ELEMENT && depth < outerDepth)) {
                return false;
            }
        }
    }

    /** Advances to the end tag of the element whose start tag is the current event. */
    public void skipElement() {
        int outerDepth = depth;
        while (nextElementWithin(outerDepth)) {
            // Its contents are not needed.
        }
    }

    /** Whether the current event is a tag with this name. */
    public boolean at(String namespace, String localName) {
        String actual = getNamespaceURI();
        return getLocalName().equals(localName) && (actual == null ? "" : actual).equals(namespace);
    }

    /** The attribute with this local name, empty if there is none. */
    public String attribute(String localName) {
        String value = getAttributeValue(null, localName);
        return value == null ? "" : value;
    }

    /**
     * Counts an element with texts of this length that stays in memory.
     *
     * @throws ModelException if the file needs too much memory
     */
    public void keep(int characters) {
        keptBytes += BYTES_PER_ELEMENT + characters;
        if (keptBytes > MAX_KEPT_BYTES) {
            throw refuse("its state machines are too large", "split them into several files");
        }
    }

    @Override
    public int next() {
        try {
            input.startToken();
            int event = super.next();
            switch (event) {
                case START_ELEMENT -> startElement();
                case END_ELEMENT -> depth--;
                case DTD -> throw refuse("contains a DOCTYPE, which is refused for security reasons", "remove it");
                case CHARACTERS, CDATA -> {
                    if (depth == 1 && strayTextLine == 0 && !isWhiteSpace()) {
                        strayTextLine = line();
                    }
                }
                case PROCESSING_INSTRUCTION -> name(getPITarget());
                default -> {}
            }
            return event;
        } catch (XMLStreamException notXml) {
            throw notXml(notXml);
        }
    }

    private void startElement() {
        if (++depth > MAX_DEPTH) {
            throw refuse("nests elements deeper than " + MAX_DEPTH, EXPORT_AGAIN);
        }
        name(getPrefix(), getLocalName());
        int attributes = getAttributeCount();
        for (int i = 0; i < attributes; i++) {
            name(getAttributePrefix(i), getAttributeLocalName(i));
        }
        for (int i = 0; i < getNamespaceCount(); i++) {
            name(getNamespacePrefix(i), String.valueOf(getNamespaceURI(i)));
        }
    }

    private void name(@Nullable String prefix, String localName) {
        name(prefix == null || prefix.isEmpty() ? localName : prefix + ':' + localName);
    }

    private void name(String name) {
        // Nearly every name is known, and finding it is faster than adding it again.
        if (names.contains(name)) {
            return;
        }
        names.add(name);
        if (names.size() > MAX_NAMES) {
            throw refuse("uses more than " + MAX_NAMES + " different names of elements and attributes", EXPORT_AGAIN);
        }
    }

    @Override
    public String getElementText() {
        try {
            String text = super.getElementText();
            depth--;
            return text;
        } catch (XMLStreamException notText) {
            throw notXml(notText);
        }
    }

    private ModelException refuse(ForeignFormat foreign) {
        return new ModelException(
                message("is " + foreign.what() + ", which Evoloop does not read", 0, foreign.remedy()));
    }

    /**
     * Refuses a document of a format that is known and not read.
     *
     * @throws ModelException if its head shows such a format
     */
    public void refuseForeign(XmiHead head) {
        ForeignFormat.of(head).ifPresent(foreign -> {
            throw refuse(foreign);
        });
    }

    /** {@code FILE: what (line N): remedy}. */
    public ModelException refuse(String what, String remedy) {
        return new ModelException(message(what, getParent() == null ? 0 : line(), remedy));
    }

    private ModelException notXml(XMLStreamException cause) {
        Throwable nested = cause.getNestedException();
        Location location = cause.getLocation();
        int line = location == null ? 0 : location.getLineNumber();
        // The parser's own text starts with the position, which the message already has.
        if (nested instanceof CharacterCodingException) {
            return new ModelException(
                    message("contains bytes that are invalid in its declared encoding", line, "save it in UTF-8"),
                    cause);
        }
        String text = String.valueOf(nested == null ? cause.getMessage() : nested.getMessage());
        String reason = text.substring(text.lastIndexOf("Message: ") < 0 ? 0 : text.lastIndexOf("Message: ") + 9);
        return new ModelException(message("is damaged or not XML, " + reason, line, EXPORT_AGAIN), cause);
    }

    private String message(String what, int line, String remedy) {
        return file + ": " + what + (line > 0 ? " (line " + line + ")" : "") + ": " + remedy;
    }

    @Override
    public void close() {
        try {
            input.close();
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }
}
