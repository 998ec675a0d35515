"""What the codes and other methods say of the displacement, each with the conditions under which it may be used."""
