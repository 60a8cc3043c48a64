package org.evoloop.mqtt;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.util.Collection;
import javax.net.ssl.TrustManagerFactory;

/** Trusts the certificates of a file. */
final class Trust {
    private Trust() {}

    /** @throws IllegalArgumentException if the file cannot be read, or contains no certificate */
    static TrustManagerFactory in(Path file) {
        Collection<? extends Certificate> certificates;
        try {
            // All bytes first: the file may be a pipe, in which the JDK's stream may fail to find its place.
            certificates = CertificateFactory.getInstance("X.509")
                    .generateCertificates(new ByteArrayInputStream(Files.readAllBytes(file)));
        } catch (IOException unreadable) {
            throw new IllegalArgumentException("the certificates of ca=" + file
                    + " cannot be read; check that the file is there, and that this user may read it");
        } catch (CertificateException malformed) {
            throw noCertificate(file);
        }
        if (certificates.isEmpty()) {
            throw noCertificate(file);
        }
        try {
            KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
            store.load(null, null);
            for (Certificate each : certificates) {
                store.setCertificateEntry("ca" + store.size(), each);
            }
            TrustManagerFactory trust = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
            trust.init(store);
            return trust;
        } catch (GeneralSecurityException | IOException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private static IllegalArgumentException noCertificate(Path file) {
        return new IllegalArgumentException(
                "ca=" + file + " holds no certificate; it must be in PEM, with -----BEGIN CERTIFICATE-----");
    }
}
