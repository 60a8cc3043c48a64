package org.evoloop.benchmarks.loading;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * Reads every element and attribute of a file with the JDK's StAX parser and keeps nothing: the minimum cost of
 * reading.
 */
final class ParseStax {
    private static final XMLInputFactory FACTORY = XMLInputFactory.newDefaultFactory();

    private ParseStax() {}

    /** The total length of all element names, attribute names and attribute values, in characters. */
    static long characters(Path file) throws IOException {
        try (InputStream bytes = new BufferedInputStream(Files.newInputStream(file))) {
            XMLStreamReader reader = FACTORY.createXMLStreamReader(bytes);
            long characters = 0;
            while (reader.hasNext()) {
                if (reader.next() == XMLStreamConstants.START_ELEMENT) {
                    characters += reader.getLocalName().length();
                    for (int index = 0; index < reader.getAttributeCount(); index++) {
                        characters += reader.getAttributeLocalName(index).length()
                                + reader.getAttributeValue(index).length();
                    }
                }
            }
            return characters;
        } catch (XMLStreamException notXml) {
            throw new IOException(notXml);
        }
    }
}
